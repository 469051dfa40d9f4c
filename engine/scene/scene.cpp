#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/built.h"
#include "engine/math/hash.h"
#include "engine/math/portable.h"
#include "engine/scene/scene_state.h"

namespace onggi {
namespace {

constexpr double kLongestTick = 0.005;
constexpr double kShortestTick = 1e-6;
constexpr int kLumpBudget = 8192;  // elements a tick while a lump is put on or taken back

}  // namespace

// Stage 1. Nothing implausible goes any further.
void Scene::State::take_input(Tick& tick, const Hands& hands, double dt) noexcept {
  tick.dt = dt > 0.0 ? std::min(dt, kLongestTick) : kShortestTick;
  if (tick.dt != dt) {
    faults |= kFaultTime;
    ++counters.clamped_times;
  }
  if (std::isfinite(hands.wheel_speed)) {
    wheel_asked = hands.wheel_speed;
  } else {
    faults |= kFaultInput;
    ++counters.held_samples;
  }
  for (std::size_t n = 0; n < hand.size(); ++n) take_hand(tick, n, hands.hand[n]);
}

void Scene::State::take_hand(Tick& tick, std::size_t n, const HandInput& in) noexcept {
  HandState& h = hand[n];
  if (!in.active) {
    h.leave();
    return;
  }
  tick.sweep[n].seconds = tick.dt;
  tick.held[n] = !h.take(in, tools, tick.sweep[n]);
  if (!tick.held[n]) return;
  faults |= kFaultInput;
  ++counters.held_samples;
}

// Stage 2. The motor follows the asked speed at its own pace.
void Scene::State::turn_wheel(Tick& tick) noexcept {
  const double asked = std::clamp(wheel_asked, -def.wheel.max_speed, def.wheel.max_speed);
  const double most = def.wheel.acceleration * tick.dt;
  const double before = wheel_speed;
  wheel_speed += std::clamp(asked - wheel_speed, -most, most);
  tick.angle_from = wheel_angle;
  tick.turn = 0.5 * (before + wheel_speed) * tick.dt;
  const double full = 2.0 * portable::kPi;
  wheel_angle += tick.turn;
  if (wheel_angle >= full) wheel_angle -= full;
  if (wheel_angle < 0.0) wheel_angle += full;
  if (wheel_angle >= full) wheel_angle = 0.0;  // -tiny + 2 pi rounds to 2 pi
}

// Stage 3. The sponge is where the hands are.
void Scene::State::soak_or_dry(const Tick& tick, bool sponge) noexcept {
  if (!moisture) return;
  for (const HandState& h : hand)
    if (h.present && h.contact.touching()) sponge |= tools[h.tool].shape->wets;
  std::array<double, kMaxHands> heights{};
  std::size_t held = 0;
  for (const HandState& h : hand)
    if (h.present) heights[held++] = h.at.y;
  moisture->soak_or_dry(*def.moisture, clay, tick.dt, sponge, std::span(heights).first(held));
}

double Scene::State::wetness_at(double height) const {
  return moisture ? moisture->at(clay, height) : 0.0;
}

Yielding Scene::State::yielding_at(double height) const {
  const double soft = moisture ? softness(*def.moisture, wetness_at(height)) : 1.0;
  return {def.contact.relaxation_time * soft, def.contact.stiffness};
}

// Stage 4. A fresh lump, or the last step back, a few rows a tick.
void Scene::State::work_on_lump(const Hands& hands) noexcept {
  if (lump_work == LumpWork::none) {
    if (hands.renew && !renew_held)
      lump_work = history ? LumpWork::keeping : LumpWork::renewing;
    else if (hands.restore && !restore_held && history && history->can_step_back())
      lump_work = LumpWork::restoring;
  }
  renew_held = hands.renew;
  restore_held = hands.restore;
  if (lump_work == LumpWork::none) return;
  for (HandState& h : hand) h.leave();
  slit.forget();
  if (lump_work == LumpWork::keeping) {
    if (history->begin_step(clay, kLumpBudget)) lump_work = LumpWork::renewing;
    return;
  }
  if (lump_work == LumpWork::settling || lump_work == LumpWork::laying) {
    const bool fresh = lump_work == LumpWork::laying;
    if (row_effects->settle_some(def, clay, fresh, steps_taken(), kLumpBudget))
      lump_work = LumpWork::none;
    return;
  }
  const bool fresh = lump_work == LumpWork::renewing;
  if (!(fresh ? clay.renew_some(kLumpBudget) : history->step_back_some(clay, kLumpBudget))) return;
  // A pot that fell is wanted as it stood, not as it was halfway down; one that tore, as it was
  // before, though it has sagged since.
  if (!fresh && history->can_step_back() &&
      ((fallen() && history->depth() > stood_at) ||
       (row_effects && row_effects->torn_before(history->depth()))))
    return;
  lump_work = !row_effects ? LumpWork::none : fresh ? LumpWork::laying : LumpWork::settling;
}

// Stage 4, at the tick's end: what a visitor may want back.
void Scene::State::keep_history(const Tick& tick) noexcept {
  if (!history || lump_work == LumpWork::keeping || lump_work == LumpWork::restoring) return;
  bool busy = lump_work == LumpWork::renewing || lump_work == LumpWork::laying;
  for (const HandState& h : hand) busy = busy || (h.present && h.contact.touching());
  if (row_effects) {
    busy = busy || row_effects->moving();
    if (row_effects->stands()) stood_at = history->depth();
  }
  history->follow(clay, busy, tick.dt);
}

// Stages 8 and 9. The guard is always last.
Feedback Scene::State::guard_and_report(const Tick& tick) noexcept {
  const GuardLimits limits{def.guard.max_force, def.guard.max_slew, def.guard.engage_time};
  Feedback out;
  for (std::size_t n = 0; n < hand.size(); ++n) {
    HandState& h = hand[n];
    HandFeedback& felt = out.hand[n];
    bool finite = true;
    felt.force = h.guard.step(tick.wanted[n], tick.dt, limits, finite);
    if (!finite) faults |= kFaultForce;
    const Press& press = tick.press[n];
    felt.contact = h.present && press.touched > 0;
    felt.side = tick.side[n];
    felt.place = tick.place[n];
    felt.depth = h.present ? press.depth : 0.0;
    counters.visited_elements += static_cast<std::uint64_t>(press.visited);
    counters.touched_elements += static_cast<std::uint64_t>(press.touched);
  }
  ++counters.ticks;
  time += tick.dt;
  if (!slit.free()) clay_angle = wheel_angle;
  out.wheel_angle = wheel_angle;
  out.clay_angle = clay_angle;
  out.cut_free = slit.share();
  out.wheel_speed = wheel_speed;
  if (row_effects) {
    out.sinking = row_effects->sinking();
    out.fallen = row_effects->fallen();
    out.torn = row_effects->torn();
  }
  out.wetness = moisture ? moisture->mean() : 0.0;
  out.faults = faults;
  faulted |= faults;
  return out;
}

Result<Scene> Scene::create(const SceneDef& def) {
  if (auto good = validate(def); !good) return tl::unexpected<Problem>(good.error());
  Result<Clay> clay = Clay::create(def.clay);
  if (!clay) return tl::unexpected<Problem>(clay.error());
  return Scene(std::make_unique<State>(def, std::move(*clay)));
}

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

// The numbered pipeline: engine/docs/pipeline.md.
Feedback Scene::step(const Hands& hands, double dt) noexcept {
  State& s = *state_;
  State::Tick tick;
  s.take_input(tick, hands, dt);                                  // 1
  s.turn_wheel(tick);                                             // 2
  if constexpr (kEffectsBuilt) s.soak_or_dry(tick, hands.water);  // 3
  s.work_on_lump(hands);                                          // 4
  if (s.printed) {
    s.press_as_printed(tick);  // 5, 7
  } else {
    s.press_clay(tick);                       // 5
    if (s.row_effects) s.work_on_rows(tick);  // 6
    s.feel(tick);                             // 7
  }
  s.keep_history(tick);
  return s.guard_and_report(tick);  // 8, 9
}

const SceneDef& Scene::def() const { return state_->def; }
const Clay& Scene::clay() const { return state_->clay; }
bool Scene::fallen() const { return state_->fallen(); }
bool Scene::torn(int row) const {
  return state_->clay.areas() != nullptr && state_->clay.areas()->torn(row);
}
double Scene::wetness_of(int row) const {
  return state_->moisture ? state_->moisture->of_row(row) : 0.0;
}
bool Scene::can_restore() const { return state_->history && state_->history->can_step_back(); }
int Scene::take_dirty_row(int from) noexcept { return state_->clay.take_dirty(from); }
int Scene::take_moved_row(int from) noexcept { return state_->clay.take_moved(from); }
void Scene::mark_all_dirty() noexcept { state_->clay.mark_all_dirty(); }
HandView Scene::hand(int n) const noexcept {
  const HandState& h = state_->hand[static_cast<std::size_t>(n)];
  return seen(h, state_->tools[h.tool]);
}
void Scene::clear_faults(std::uint32_t which) noexcept { state_->faults &= ~which; }
const SceneCounters& Scene::counters() const { return state_->counters; }
double Scene::time() const { return state_->time; }

std::uint64_t Scene::state_hash() const {
  const State& s = *state_;
  StateHash hash;
  for (double v :
       {s.time, s.wheel_angle, s.wheel_speed, s.wheel_asked, s.moisture ? s.moisture->mean() : 0.0})
    hash.add(v);
  for (const HandState& h : s.hand) h.add_to(hash, s.tools);
  s.slit.add_to(hash);
  if (s.slit.free()) hash.add(s.clay_angle);
  hash.add(std::uint64_t{s.renew_held} | std::uint64_t{s.restore_held} << 1 |
           static_cast<std::uint64_t>(s.lump_work) << 2 | std::uint64_t{s.faulted} << 8);
  if (s.printed)
    for (const PaperFilter& filter : s.printed->filter)
      for (double v : filter.memory()) hash.add(v);
  if (s.moisture) s.moisture->add_to(hash);
  if (s.row_effects) {
    s.row_effects->add_to(hash, state_->clay);
    hash.add(s.stood_at);
  }
  hash.add(s.clay.hash());
  if (s.history) s.history->add_to(hash);
  return hash.value();
}

}  // namespace onggi

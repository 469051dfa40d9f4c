#include "engine/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/clay/history.h"
#include "engine/contact/paper_model.h"
#include "engine/contact/stops.h"
#include "engine/math/hash.h"
#include "engine/math/portable.h"
#include "engine/scene/hand_state.h"

namespace onggi {
namespace {

constexpr double kLongestTick = 0.005;
constexpr double kShortestTick = 1e-6;
constexpr int kLumpBudget = 8192;  // elements a tick while a lump is put on or taken back

constexpr Vec3 kDown{0.0, -1.0, 0.0};

// What the paper's scene has besides.
struct Printed {
  PaperModel model;
  PaperCoefficients coefficients;
  std::array<PaperFilter, kMaxHands> filter{};
};

enum class LumpWork : std::uint8_t { none, keeping, renewing, restoring };

}  // namespace

struct Scene::State {
  SceneDef def;
  std::vector<Tool> tools;
  Clay clay;
  std::optional<History> history;
  WireCut slit;
  std::array<HandState, kMaxHands> hand{};
  std::optional<Printed> printed;
  double time = 0.0;
  double wheel_angle = 0.0;
  double clay_angle = 0.0;
  double wheel_speed = 0.0;
  double wheel_asked = 0.0;
  std::optional<Moisture> moisture;
  bool renew_held = false;
  bool restore_held = false;
  LumpWork lump_work = LumpWork::none;
  std::uint32_t faults = 0;
  SceneCounters counters;

  // What the stages of one tick hand to each other.
  struct Tick {
    double dt = 0.0;
    double angle_from = 0.0;
    double turn = 0.0;
    std::array<ToolSweep, kMaxHands> sweep{};
    std::array<bool, kMaxHands> held{};
    std::array<Vec3, kMaxHands> wanted{};
    std::array<Press, kMaxHands> press{};
    std::array<WallSide, kMaxHands> side{};
    std::array<Place, kMaxHands> place{};
  };

  State(const SceneDef& d, Clay&& c)
      : def(d), tools(tools_of(d)), clay(std::move(c)), slit(d.clay.sectors) {
    if (def.moisture) moisture.emplace(*def.moisture, def.clay.rows);
    if (def.clay.keep_undo) history.emplace(clay);
    if (!def.paper) return;
    const PaperDef& paper = *def.paper;
    printed = Printed{PaperModel(clay), {paper.c_eta, paper.c_v, paper.c_r}};
  }

  void take_input(Tick& tick, const Hands& hands, double dt) noexcept;
  void take_hand(Tick& tick, std::size_t n, const HandInput& in) noexcept;
  void turn_wheel(Tick& tick) noexcept;
  void soak_or_dry(const Tick& tick, bool sponge) noexcept;
  void work_on_lump(const Hands& hands) noexcept;
  double wetness_at(double height) const;
  Yielding yielding_at(double height) const;
  void keep_history(const Tick& tick) noexcept;
  bool presses(const HandState& h) const { return h.present && !tools[h.tool].shape->severs; }
  void draw_wire(Tick& tick, std::size_t n) noexcept;
  void press_clay(Tick& tick) noexcept;
  void feel(Tick& tick) noexcept;
  void press_as_printed(Tick& tick) noexcept;
  Feedback guard_and_report(const Tick& tick) noexcept;
};

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
  const bool done = lump_work == LumpWork::renewing ? clay.renew_some(kLumpBudget)
                                                    : history->step_back_some(clay, kLumpBudget);
  if (done) lump_work = LumpWork::none;
}

// Stage 4, at the tick's end: what a visitor may want back.
void Scene::State::keep_history(const Tick& tick) noexcept {
  if (!history || lump_work == LumpWork::keeping || lump_work == LumpWork::restoring) return;
  const bool touching = std::ranges::any_of(
      hand, [](const HandState& h) { return h.present && h.contact.touching(); });
  history->follow(clay, touching || lump_work == LumpWork::renewing, tick.dt);
}

// Stage 5, for a wire.
void Scene::State::draw_wire(Tick& tick, std::size_t n) noexcept {
  const ToolSweep& way = tick.sweep[n];
  const WireSweep sweep{way.from, way.to, way.along, way.size.length, tick.angle_from + tick.turn,
                        tick.dt};
  tick.press[n] = slit.draw(clay, sweep, hand[n].wire, def.contact.stiffness);
}

// Stage 5. Both hands advance together in small steps, so that neither runs ahead of the other.
void Scene::State::press_clay(Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n)
    if (hand[n].present && tools[hand[n].tool].shape->severs) draw_wire(tick, n);
  if (slit.free()) {
    for (HandState& h : hand) h.contact = {};
    return;
  }
  std::array<Yielding, kMaxHands> yielding;
  int steps = 1;
  for (std::size_t n = 0; n < hand.size(); ++n) {
    hand[n].contact.begin_tick();
    if (!presses(hand[n])) continue;
    tick.sweep[n].angle_from = tick.angle_from;
    tick.sweep[n].angle_to = tick.angle_from + tick.turn;
    yielding[n] = yielding_at(hand[n].at.y);
    steps = std::max(steps, steps_for(tick.sweep[n], yielding[n].relaxation_time));
  }
  for (int step = 0; step < steps; ++step) {
    // What a wall between two hands comes to must not depend on which hand is called the first.
    const bool swapped = hand[0].contact.side() > hand[1].contact.side();
    for (const std::size_t n : {std::size_t{swapped}, std::size_t{!swapped}})
      if (presses(hand[n])) hand[n].contact.step(clay, tick.sweep[n], step, steps, yielding[n]);
  }
  for (std::size_t n = 0; n < hand.size(); ++n) {
    if (hand[n].present && !presses(hand[n])) continue;
    tick.press[n] = hand[n].contact.reaction();
    tick.side[n] = hand[n].contact.side();
    tick.place[n] = hand[n].contact.place();
  }
}

// Stage 7. Reaction, friction, and the stop that is not clay: the wheel head.
void Scene::State::feel(Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n) {
    const HandState& h = hand[n];
    if (!h.present || tick.held[n]) continue;
    const ToolShape& shape = *tools[h.tool].shape;
    const ToolSize& size = tools[h.tool].size;
    const ToolPlace place{h.at, h.along, h.across};
    const Press& press = tick.press[n];
    Vec3 force = press.force;
    const double strength = length(press.force);
    if (def.friction && press.normal > 0.0 && strength > 0.0) {
      const FrictionDef& friction = *def.friction;
      const double mu = friction_coefficient(friction, wetness_at(h.at.y));
      const ToolBall ball = ball_towards(shape, place, size, (-1.0 / strength) * press.force);
      const Vec3 touch = ball.middle - (ball.radius / strength) * press.force;
      const Vec3 slip =
          (1.0 / tick.dt) * (h.at - tick.sweep[n].from) - clay_velocity(touch, tick.turn / tick.dt);
      force += friction_force(press.force, press.normal, slip, mu, friction.slip_speed);
    }
    const ToolBall lowest = ball_towards(shape, place, size, kDown);
    force.y += stop_force(lowest.radius - lowest.middle.y, lowest.radius, def.contact.stiffness);
    tick.wanted[n] = force;
  }
}

// Stages 5 and 7 as the paper has them: no steps within the tick, no stops, and a filter.
void Scene::State::press_as_printed(Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n) {
    PaperFilter& filter = printed->filter[n];
    if (!hand[n].present) {
      filter.settle();
      continue;
    }
    const double angle = tick.angle_from + tick.turn;
    tick.side[n] = PaperModel::mode(clay, hand[n].at, angle, tick.sweep[n].wish);
    tick.place[n] = beside(tick.side[n]);
    const PaperTouch touch = printed->model.tick(clay, tick.side[n], hand[n].at, def.tool.radius,
                                                 angle, tick.turn, printed->coefficients);
    tick.press[n] = {touch.force, 0.0, touch.depth, touch.visited, touch.touched};
    const Vec3 filtered = filter.filter(touch.force);
    if (!tick.held[n]) tick.wanted[n] = filtered;
  }
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
  out.wetness = moisture ? moisture->mean() : 0.0;
  out.faults = faults;
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
  s.take_input(tick, hands, dt);     // 1
  s.turn_wheel(tick);                // 2
  s.soak_or_dry(tick, hands.water);  // 3
  s.work_on_lump(hands);             // 4
  if (s.printed) {
    s.press_as_printed(tick);  // 5, 7
  } else {
    s.press_clay(tick);  // 5
                         // 6: effects, where the scene has them
    s.feel(tick);        // 7
  }
  s.keep_history(tick);
  return s.guard_and_report(tick);  // 8, 9
}

const SceneDef& Scene::def() const { return state_->def; }
const Clay& Scene::clay() const { return state_->clay; }
double Scene::wetness_of(int row) const {
  return state_->moisture ? state_->moisture->of_row(row) : 0.0;
}
bool Scene::can_restore() const { return state_->history && state_->history->can_step_back(); }
int Scene::take_dirty_row(int from) noexcept { return state_->clay.take_dirty(from); }
void Scene::mark_all_dirty() noexcept { state_->clay.mark_all_dirty(); }
void Scene::clear_faults() noexcept { state_->faults = 0; }
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
           static_cast<std::uint64_t>(s.lump_work) << 2 | std::uint64_t{s.faults} << 8);
  if (s.printed)
    for (const PaperFilter& filter : s.printed->filter)
      for (double v : filter.memory()) hash.add(v);
  if (s.moisture) s.moisture->add_to(hash);
  hash.add(s.clay.hash());
  if (s.history) s.history->add_to(hash);
  return hash.value();
}

}  // namespace onggi

#include "engine/scene/scene_state.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/stops.h"
#include "engine/effects/built.h"
#include "engine/math/portable.h"
#include "engine/scene/long_tick.h"

namespace onggi {
namespace {

constexpr double kLongestTick = 0.005;
constexpr double kShortestTick = 1e-6;
constexpr Vec3 kDown{0.0, -1.0, 0.0};
constexpr double kOfAQuadratic = 2.0;  // dF/dl over F/l, for a round body with F ~ l^2

// Elements are pressed by at most `depth`, so the stiffness is at least `normal` / `depth`: exactly
// that for a flat body, twice that for a round one.
force::Touch touch_of(const Press& press, double normal, bool severs) {
  force::Touch touch;
  if (severs) {
    touch.grip = length(press.force);
  } else {
    touch.push = press.force;
    if (press.depth > 0.0) touch.stiffness = kOfAQuadratic * normal / press.depth;
  }
  return touch;
}

// A vector of the studio's frame in that of a clay which is turned by `angle`; -angle: back.
Vec3 turned_back(Vec3 v, double angle) {
  const double c = portable::cos(angle), s = portable::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

}  // namespace

// Stage 1. Rejects implausible input.
void Scene::State::take_input(Tick& tick, const Hands& hands, double dt) noexcept {
  tick.dt = dt >= kShortestTick ? std::min(dt, kLongestTick) : kShortestTick;
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
  scene::HandState& h = hand[n];
  if (!in.active) {
    h.leave();
    h.blow = false;
    return;
  }
  tick.sweep[n].seconds = tick.dt;
  HandInput here = in;
  here.coil = in.coil && !in.paddle && building() != nullptr;
  here.paddle = effects::kBuilt && in.paddle && def.beating;
  tick.held[n] = !h.take(here, tools, tick.sweep[n]);
  if (!tick.held[n]) return;
  faults |= kFaultInput;
  ++counters.held_samples;
}

// Stage 2. The motor follows the requested speed with its own acceleration.
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

// Stage 3. A sponge wets the clay that it touches. Water without a sponge in hand comes at the
// hands, wherever they are.
void Scene::State::soak_or_dry(const Tick& tick, bool water, bool fire) noexcept {
  if (!moisture) return;
  std::array<double, kMaxHands> heights{};
  std::size_t held = 0;
  for (const scene::HandState& h : hand) {
    const bool sponge = h.contact.touching() && tools[h.tool].shape->wets;
    if (h.present && (water || sponge)) heights[held++] = h.at.y;
  }
  moisture->soak_or_dry(*def.moisture, clay, tick.dt, water || held > 0,
                        std::span(heights).first(held), fire);
}

double Scene::State::wetness_at(double height) const {
  return moisture ? moisture->at(clay, height) : 0.0;
}

Yielding Scene::State::yielding_at(double height) const {
  const double soft = moisture ? effects::softness(*def.moisture, wetness_at(height)) : 1.0;
  return {def.contact.relaxation_time * soft, def.contact.stiffness};
}

// Stage 4. During work on the lump, nothing else touches it.
void Scene::State::work_on_lump(const Hands& hands) noexcept {
  if (!lump.step(hands, lump_parts())) return;
  for (scene::HandState& h : hand) h.leave();
  slit.forget();
}

// Stage 4, at the tick's end: keeps what a visitor may undo.
void Scene::State::keep_history(const Tick& tick) noexcept {
  bool touching = false;
  for (const scene::HandState& h : hand)
    touching = touching || (h.present && (h.contact.touching() || h.rests || h.struck > 0.0));
  lump.follow(lump_parts(), touching, tick.dt);
}

// Stages 5 and 6. A long tick, after a late thread, is split into parts.
void Scene::State::press_and_work(Tick& tick) noexcept {
  if (!row_effects) return press_clay(tick);
  const int parts = scene::parts_of(tick.dt);
  if (parts == 1) {
    press_clay(tick);
    return work_on_rows(tick);
  }
  const double share = 1.0 / parts;
  std::array<Press, kMaxHands> sum{};
  Tick part = tick;
  part.dt = share * tick.dt;
  part.turn = share * tick.turn;
  for (int k = 0; k < parts; ++k) {
    part.angle_from = tick.angle_from + k * part.turn;
    for (std::size_t n = 0; n < hand.size(); ++n) {
      const ToolSweep& whole = tick.sweep[n];
      const Vec3 way = whole.to - whole.from;
      part.sweep[n].from = whole.from + (k * share) * way;
      part.sweep[n].to = k + 1 < parts ? whole.from + ((k + 1) * share) * way : whole.to;
      part.sweep[n].seconds = part.dt;
      part.press[n] = {};
    }
    press_clay(part);
    work_on_rows(part);
    for (std::size_t n = 0; n < hand.size(); ++n) {
      const Press& press = part.press[n];
      sum[n].force += share * press.force;
      sum[n].normal += share * press.normal;
      sum[n].depth = std::max(sum[n].depth, press.depth);
      sum[n].visited += press.visited;
      sum[n].touched += press.touched;
    }
  }
  tick.press = sum;
  tick.along = part.along;
  tick.side = part.side;
  tick.place = part.place;
}

// Stage 6. Fresh rows must be measured first.
void Scene::State::work_on_rows(const Tick& tick) noexcept {
  if (!lump.playing()) return;
  const double angle = tick.angle_from + 0.5 * tick.turn;
  scene::RowEffects::Tick rows;
  rows.moisture = moisture ? &*moisture : nullptr;
  rows.history = history ? &*history : nullptr;
  rows.wheel_speed = slit.free() ? 0.0 : wheel_speed;
  rows.seconds = tick.dt;
  // Rows are checked in turn, so a row found torn at the beginning of a step tore in the step
  // before.
  constexpr double kLooking = 0.25;  // s
  const bool begun = history && history->depth() > 0 && history->lasted() < kLooking;
  rows.step = begun ? steps_taken() - 1 : steps_taken();
  for (std::size_t n = 0; n < hand.size(); ++n) {
    const scene::HandState& h = hand[n];
    const Press& press = tick.press[n];
    rows.touched = rows.touched || press.touched > 0;
    if (!presses(h) || press.touched == 0) continue;
    const scene::Tool& tool = tools[h.tool];
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    const Vec3 at = 0.5 * (tick.sweep[n].from + tick.sweep[n].to);
    rows.hand[n] = {{c * at.x + s * at.z, at.y, c * at.z - s * at.x},
                    press.normal,
                    h.contact.place() == beside(h.contact.side()),
                    h.contact.side(),
                    tick.along[n],
                    tool.shape->smooths ? tool.shape->reach(tool.size) : 0.0};
  }
  const bool beats = effects::kBuilt && def.beating && !slit.free();
  for (std::size_t n = 0; beats && n < hand.size(); ++n) rows.blow[n] = blow_of(tick, n);
  row_effects->run(def, clay, rows);
  if (beats) take_struck(tick);
}

// Stage 6.9, a hand's blow.
effects::Blow Scene::State::blow_of(const Tick& tick, std::size_t n) const noexcept {
  const scene::HandState& h = hand[n];
  if (!h.present || !h.strikes) return {};
  const scene::HandState& other = hand[1 - n];
  const Vec3 way = tick.sweep[n].to;
  const Vec3 at = turned_back(way, tick.angle_from + tick.turn);
  const SideWish wish = tick.sweep[n].wish;
  const bool outside = wish == SideWish::by_position ? effects::outside_of_wall(clay, at)
                                                     : wish == SideWish::outside;
  effects::Blow blow{true, at, outside ? WallSide::outside : WallSide::inside,
                     tools[h.tool].size.radius};
  const bool holds = presses(other) && row_effects->holds(1 - n) &&
                     (other.contact.side() == WallSide::outside) != outside;
  const WallsDef& walls = def.walls ? *def.walls : WallsDef{};
  const double held = holds ? effects::wall_support(walls, way, tick.sweep[1 - n].to) : 0.0;
  // Whichever is harder behind the wall: else the weakest anvil would take the hand's place.
  const double against = std::max(h.anvil, h.swing * held);
  blow.squeezes = std::min(h.swing, against);
  blow.moves = h.swing - against;
  blow.anvil = h.anvil > h.swing * held;
  blow.left = way.x < 0.0;
  return blow;
}

// After the blows: a blow of a long tick lands in its first part.
void Scene::State::take_struck(const Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n) {
    scene::HandState& h = hand[n];
    if (!h.strikes) continue;
    h.strikes = false;
    const effects::Struck struck = row_effects->struck(n);
    h.struck = struck.force;
    h.struck_out = turned_back(struck.out, -(tick.angle_from + tick.turn));
  }
}

// Stage 7. Reaction, friction, and the wheel head, a stop that is not clay.
void Scene::State::feel(Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n) {
    scene::HandState& h = hand[n];
    if (!h.present) continue;
    const Vec3 velocity = effects::kBuilt && def.friction ? h.velocity.go(h.at, tick.dt) : Vec3{};
    if (tick.held[n]) continue;
    const ToolShape& shape = *tools[h.tool].shape;
    const ToolSize& size = tools[h.tool].size;
    const ToolPlace place{h.at, h.along, h.across};
    const Press& press = tick.press[n];
    Vec3 force = press.force;
    const double strength = length(press.force);
    force::Touch& touch = tick.touch[n];
    touch = touch_of(press, std::max(press.normal, strength), shape.severs());
    // A soft tool yields itself, so the clay takes that much longer (tool_contact.cpp).
    touch.relaxation = shape.relaxation / shape.softness * yielding_at(h.at.y).relaxation_time;
    if (effects::kBuilt && def.friction && press.normal > 0.0 && strength > 0.0) {
      const FrictionDef& friction = *def.friction;
      const double mu = effects::friction_coefficient(friction, wetness_at(h.at.y));
      const body::Ball ball = shape.support(place, size, (-1.0 / strength) * press.force);
      touch.clay = effects::clay_velocity(ball.middle - (ball.radius / strength) * press.force,
                                          tick.turn / tick.dt);
      touch.grip = mu * press.normal;
      const Vec3 slip = velocity - touch.clay;
      force += effects::friction_force(press.force, press.normal, slip, mu, friction.slip_speed);
    }
    tick.wanted[n] = force;
    const body::Ball lowest = shape.support(place, size, kDown);
    const double below = lowest.radius - lowest.middle.y;
    if (below > 0.0) feel_stop(tick, n, below, lowest.radius, {0.0, 1.0, 0.0});
    if (row_effects) feel_coil(tick, n);
    if (effects::kBuilt && h.paddle) feel_wall(tick, n);
  }
}

// Stage 7. Something firm, in which a ball of `radius` lies `depth` deep (m), pushes it `out`
// (studio frame, unit).
void Scene::State::feel_stop(Tick& tick, std::size_t n, double depth, double radius,
                             Vec3 out) noexcept {
  const double stop = stop_force(depth, radius, def.contact.stiffness);
  if (!(stop > 0.0)) return;
  tick.touch[n].push += stop * out;
  tick.touch[n].relaxation = 0.0;
  tick.touch[n].stiffness += kOfAQuadratic * stop / depth;
  tick.wanted[n] += stop * out;
}

// Stage 7. A coil on the rim is firm until its ring is closed: a round tool feels it, and others
// pass through. A hand that holds a coil feels the rim through it instead.
void Scene::State::feel_coil(Tick& tick, std::size_t n) noexcept {
  const effects::Building* const built = building();
  if (built == nullptr) return;
  const effects::LaidCoil& laid = built->laid();
  const scene::HandState& h = hand[n];
  if (slit.free() || h.used_up || h.paddle) return;
  if (!h.coil && (!laid.any() || laid.closed() || !tools[h.tool].shape->round())) return;
  const double angle = tick.angle_from + tick.turn;
  const double c = portable::cos(angle), s = portable::sin(angle);
  const double coil = def.building->coil;
  const double height = built->laid_height(*def.building, clay);
  const body::Ball ball{h.at, h.coil ? 0.5 * coil : tools[h.tool].size.radius};
  const Vec3 at{c * ball.middle.x + s * ball.middle.z, ball.middle.y,
                c * ball.middle.z - s * ball.middle.x};
  const effects::Overlap found = h.coil ? effects::rim_touched(clay, at, ball.radius)
                                        : laid.touched(clay, at, ball.radius, coil, height);
  feel_stop(tick, n, found.depth, ball.radius,
            {c * found.out.x - s * found.out.z, found.out.y, s * found.out.x + c * found.out.z});
}

// Stage 7. The wall is firm for a hand with a paddle, because only blows shape it.
void Scene::State::feel_wall(Tick& tick, std::size_t n) noexcept {
  scene::HandState& h = hand[n];
  h.rests = false;
  if (slit.free() || !lump.playing()) return;
  const double radius = tools[h.tool].size.radius, angle = tick.angle_from + tick.turn;
  const effects::Overlap found = effects::wall_touched(clay, turned_back(h.at, angle), radius);
  h.rests = found.depth > 0.0;
  feel_stop(tick, n, found.depth, radius, turned_back(found.out, -angle));
}

// Stages 5 and 7 as printed in the paper: no steps within the tick, no stops, and a filter.
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
    if (tick.held[n]) continue;
    tick.wanted[n] = filtered;
    tick.touch[n] = touch_of(tick.press[n], length(filtered), false);
    tick.touch[n].push = filtered;
  }
}

// Stages 8 and 9. The guard is always last.
Feedback Scene::State::guard_and_report(const Tick& tick) noexcept {
  const force::GuardLimits limits{def.guard.max_force, def.guard.max_slew, def.guard.engage_time};
  Feedback out;
  for (std::size_t n = 0; n < hand.size(); ++n) {
    scene::HandState& h = hand[n];
    HandFeedback& felt = out.hand[n];
    bool finite = true;
    felt.force = h.guard.step(tick.wanted[n], tick.dt, limits, finite);
    if (!finite) faults |= kFaultForce;
    const Press& press = tick.press[n];
    felt.contact = h.present && (press.touched > 0 || h.rests || h.struck > 0.0);
    felt.blow = h.struck;
    felt.blow_out = h.struck_out;
    felt.side = tick.side[n];
    felt.place = tick.place[n];
    felt.depth = h.present ? press.depth : 0.0;
    felt.touch = tick.touch[n];
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
  faulted |= faults;
  out.faults = faults;
  return out;
}

}  // namespace onggi

#include <algorithm>
#include <cmath>

#include "engine/effects/built.h"
#include "engine/math/portable.h"
#include "engine/scene/scene_state.h"

// Stage 5 of a tick: tools press the clay, and what each hand feels of a wall between two hands.
namespace onggi {
namespace {

// Two hands press a wall from both sides. The weaker push as a share of the stronger: below kGrazes
// one hand only grazes the wall, above kPinches both pinch it.
constexpr double kGrazes = 0.5, kPinches = 0.7;

// Coils: a hand that the rising rim caught lies deeper than this. One that lies as deep feels 6 mN.
constexpr double kCaught = 0.02;

// Its push grows as a ball's does.
bool rounded(const ToolShape& shape) {
  return shape.body == BodyKind::ball || shape.body == BodyKind::capsule;
}

}  // namespace

// Stage 5, for a wire.
void Scene::State::draw_wire(Tick& tick, std::size_t n) noexcept {
  const ToolSweep& way = tick.sweep[n];
  const WireSweep sweep{way.from, way.to, way.along, way.size.length, tick.angle_from + tick.turn,
                        tick.dt};
  tick.press[n] = slit.draw(clay, sweep, hand[n].wire, def.contact.stiffness);
}

// Stage 5, for a coil, within the part of a tick that `tick` is.
void Scene::State::lay_coil(const Tick& tick, std::size_t n) noexcept {
  const auto in_clay = [](Vec3 at, double angle) {
    const double c = portable::cos(angle), s = portable::sin(angle);
    return Vec3{c * at.x + s * at.z, at.y, c * at.z - s * at.x};
  };
  const ToolSweep& way = tick.sweep[n];
  scene::HandState& h = hand[n];
  const Vec3 to = in_clay(way.to, tick.angle_from + tick.turn);
  if (h.used_up) {
    const double coil = def.building->coil;
    h.used_up = effects::rim_touched(clay, to, 0.5 * coil).depth > kCaught * coil;
    return;
  }
  const effects::Building* const built = building();
  if (built == nullptr) return;
  const bool rose = built->rises();
  h.rests =
      row_effects->lay(def, clay, in_clay(way.from, tick.angle_from), to, tick.dt, steps_taken());
  if (rose || !built->rises()) return;
  // The ring is closed: no hand holds what is left of a coil.
  for (scene::HandState& each : hand) each.used_up = each.coil, each.rests = false;
}

// Stage 5. Both hands advance together in small steps.
void Scene::State::press_clay(Tick& tick) noexcept {
  for (std::size_t n = 0; n < hand.size(); ++n)
    if (hand[n].present && !hand[n].coil && !hand[n].paddle && tools[hand[n].tool].shape->severs())
      draw_wire(tick, n);
  if (slit.free()) {
    for (scene::HandState& h : hand) h.contact = {}, h.rests = false;
    return;
  }
  std::array<Yielding, kMaxHands> yielding;
  int steps = 1;
  for (std::size_t n = 0; n < hand.size(); ++n) {
    hand[n].contact.begin_tick();
    if (!presses(hand[n])) continue;
    tick.sweep[n].angle_from = tick.angle_from;
    tick.sweep[n].angle_to = tick.angle_from + tick.turn;
    yielding[n] = yielding_at(tick.sweep[n].to.y);
    steps = std::max(
        steps, steps_for(tick.sweep[n], yielding[n].relaxation_time, hand[n].contact.pressed()));
  }
  if (row_effects) {
    for (std::size_t n = 0; n < hand.size(); ++n)
      if (hand[n].present && hand[n].coil && lump.playing()) lay_coil(tick, n);
    for (std::size_t n = 0; n < hand.size(); ++n) {
      const scene::HandState& other = hand[1 - n];
      const bool held = other.present && row_effects->holds(1 - n) &&
                        other.contact.side() != hand[n].contact.side();
      const ToolSweep& way = tick.sweep[n];
      const ToolSweep& its = tick.sweep[1 - n];
      const Vec3 holding = 0.5 * (its.from + its.to);
      tick.along[n] = row_effects->along(def, 0.5 * (way.from + way.to), held ? &holding : nullptr);
      yielding[n].along = tick.along[n];
    }
  }
  for (int step = 0; step < steps; ++step) {
    // What happens to a wall between two hands must not depend on the hands' numbers.
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
  const bool bends = effects::kBuilt && def.walls && def.walls->bending_strength > 0.0;
  if (!bends && !(presses(hand[0]) && presses(hand[1]))) return;
  Faces face{};
  for (std::size_t n = 0; n < hand.size(); ++n)
    if (presses(hand[n])) face[n] = hand[n].contact.on_face();
  Faces felt = face;
  balance(tick, felt);
  if (bends) bend_walls(tick, felt);
  for (std::size_t n = 0; n < hand.size(); ++n) {
    if (felt[n].normal == face[n].normal) continue;
    tick.press[n].force += felt[n].force - face[n].force;
    tick.press[n].normal += felt[n].normal - face[n].normal;
  }
}

// Stage 5. A wall pinched by two hands has no mass, so both must feel the same force. The outer
// face is longer than the inner, so equal presses sum to different forces: both get the mean. A
// hand that only grazes the wall while the other presses is left out.
void Scene::State::balance(const Tick& tick, Faces& face) const noexcept {
  const std::array<double, kMaxHands> strength{length(face[0].force), length(face[1].force)};
  const double less = std::min(strength[0], strength[1]);
  if (!(less > 0.0) || hand[0].contact.side() == hand[1].contact.side()) return;
  const double more = std::max(strength[0], strength[1]);
  const double alike = std::clamp((less / more - kGrazes) / (kPinches - kGrazes), 0.0, 1.0);
  if (alike == 0.0) return;
  const WallsDef& walls = def.walls ? *def.walls : WallsDef{};
  const double facing = effects::wall_support(walls, tick.sweep[0].to, tick.sweep[1].to);
  const double mean = 0.5 * (less + more);
  for (std::size_t n = 0; n < face.size(); ++n) {
    const double share = 1.0 + facing * alike * (mean - strength[n]) / strength[n];
    face[n].force = share * face[n].force;
    face[n].normal *= share;
  }
}

// Stage 5. A hand feels less from a wall that bends than from the clay alone. Rim and floor do not
// bend, so only the part on a face is reduced.
void Scene::State::bend_walls(const Tick& tick, Faces& face) const noexcept {
  const double angle = tick.angle_from + tick.turn;
  const double c = portable::cos(angle), s = portable::sin(angle);
  const std::array<double, kMaxHands> pushed{face[0].normal, face[1].normal};
  for (std::size_t n = 0; n < hand.size(); ++n) {
    if (face[n].normal <= 0.0) continue;
    // The other hand supports at most as much of this push as it pushes itself.
    double held = 0.0;
    const double normal = face[n].normal;
    const Vec3 way = tick.sweep[n].to;
    if (pushed[1 - n] > 0.0 && hand[0].contact.side() != hand[1].contact.side())
      held = effects::wall_support(*def.walls, way, tick.sweep[1 - n].to) *
             std::min(normal, pushed[1 - n]);
    const effects::ClearOfFoot clear = effects::clear_of_foot(clay, way.y);
    if (clear.share == 0.0) continue;
    const Vec3 at{c * way.x + s * way.z, way.y, c * way.z - s * way.x};
    const effects::WallBehind wall =
        effects::wall_behind(clay, moisture ? &*moisture : nullptr, at);
    const double strong = moisture ? effects::strength(*def.moisture, wall.wetness) : 1.0;
    const double bears = effects::wall_bears(*def.walls, wall.thickness, strong);
    const double alone = normal - held;
    const double felt = effects::wall_push(normal, bears, normal - clear.share * alone);
    // A wall that bends more easily beside the hand pulls the hand there, or a hand that goes in
    // where it is thin and comes out where it is thick would gain.
    const ToolSweep& sweep = tick.sweep[n];
    const effects::BendSlopes slopes = effects::bend_slopes(
        alone, clear.share, bears, face[n].depth, rounded(*sweep.shape) ? sweep.size.radius : 0.0);
    Vec3 firmer = 2.0 / wall.thickness * wall.thicker;
    if (moisture) firmer += portable::log(def.moisture->weakening) * wall.wetter;
    Vec3 softer = slopes.by_bears * bears * firmer;
    softer.y += slopes.by_clear * clear.rise;
    face[n].force = (felt / normal) * face[n].force +
                    Vec3{c * softer.x - s * softer.z, softer.y, s * softer.x + c * softer.z};
    face[n].normal = felt;
  }
}

}  // namespace onggi

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lab/closed_form.h"
#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"

// Written from engine/docs/contact.md.
namespace onggi::lab {
namespace {

constexpr double kBallRadius = 0.008;
constexpr double kTickSeconds = 0.001;
constexpr double kLumpRadius = 0.055;

// Largest of the two faces' `apart_on(side, place of a ball)`, on a wall of 22 to 55 mm.
template <class ApartOn>
double on_both_faces(double deep, ApartOn&& apart_on) {
  return std::max(apart_on(WallSide::outside, Vec3{kLumpRadius + kBallRadius - deep, 0.1, 0}),
                  apart_on(WallSide::inside, Vec3{0.022 - kBallRadius + deep, 0.1, 0}));
}

double clay_that_gives_way(double by) {
  return on_both_faces(0.002, [by](WallSide side, Vec3 at) {
    SceneDef def = lone_lump(200, 180);
    const double tau = def.contact.relaxation_time;
    const double stiffness = def.contact.stiffness;
    def.contact.relaxation_time *= 1.0 + by;
    Scene scene = scene_of(def);
    const Scene before = scene_of(def);
    const bool outside = side == WallSide::outside;
    const Vec3 push =
        scene.step(ball_at(at, outside ? SideWish::outside : SideWish::inside), kTickSeconds)
            .hand[0]
            .touch.push;
    const ElementSum sum = taken_press(before.clay(), scene.clay(), side, at, kBallRadius,
                                       stiffness, tau / kTickSeconds);
    return length(push - sum.force) / length(sum.force);
  });
}

double a_fresh_wall(double by) {
  return on_both_faces(0.003, [by](WallSide side, Vec3 at) {
    const SceneDef def = lone_lump(200, 180);
    const ElementSum sum = fresh_press(*Clay::create(def.clay), side, at, kBallRadius, 5e6);
    FrozenClay clay(def.clay, kBallRadius, (1.0 + by) * 5e6);
    return length(clay.push(at) - sum.force) / length(sum.force);
  });
}

// What is left of the press in front of a ball that was set down `deep` and goes on at `speed`,
// after `ticks`.
double press_left(double deep, double speed, int ticks, double by) {
  SceneDef def = lone_lump(200, 180);
  def.contact.relaxation_time *= 1.0 + by;
  Scene scene = scene_of(def);
  const int row = scene.clay().first_row_above(0.1);
  double out = kLumpRadius + kBallRadius - deep;
  for (int n = 0; n < ticks; ++n) {
    if (n > 0) out -= speed * kTickSeconds;
    scene.step(ball_at(on_first_ray(scene.clay(), row, out), SideWish::outside), kTickSeconds);
  }
  return double{scene.clay().outer(row)[0]} - (out - kBallRadius);
}

double a_held_press(double by) {
  constexpr int kHeld = 20;
  return share_apart(press_left(0.001, 0.0, kHeld, by),
                     closed_form::held_press(0.001, 0.00949, kHeld * kTickSeconds));
}

double a_press_at_speed(double by) {
  constexpr int kTicks = 61;
  return share_apart(press_left(0.0, 0.01, kTicks, by),
                     closed_form::moving_press(0.0, 0.01, 0.00949, (kTicks - 1) * kTickSeconds));
}

double a_hole(double by) {
  const double out = kLumpRadius + kBallRadius - 0.003;
  ClayDef def = lone_lump(800, 720).clay;
  Clay clay = std::move(*Clay::create(def));
  const double fresh = volume_of(clay);
  find_tool_shape("sphere")->press(clay, WallSide::outside, {Vec3{out, 0.1, 0}},
                                   {(1.0 + by) * kBallRadius, 0, 0}, 0.1, {0.001, 5e6});
  return share_apart(fresh - volume_of(clay),
                     closed_form::lens_volume(kBallRadius, kLumpRadius, out));
}

double a_groove(double by) {
  SceneDef def = lone_lump(200, 180);
  def.tool.radius *= 1.0 + by;
  Scene scene = scene_of(def);
  const double out = kLumpRadius + kBallRadius - 0.002;
  Hands hands = ball_at({out, 0.1, 0}, SideWish::outside);
  hands.wheel_speed = 31.4;
  for (int n = 0; n < 10'000; ++n) scene.step(hands, kTickSeconds);
  double most = 0.0;
  const Clay& clay = scene.clay();
  for (int j = 0; j < clay.rows(); ++j) {
    const double should =
        closed_form::groove(kLumpRadius, kBallRadius, out, clay.row_height(j) - 0.1);
    for (const float r : clay.outer(j)) most = std::max(most, std::fabs(double{r} - should));
  }
  return most;
}

double a_light_touch(double by) {
  FrozenClay clay(lone_lump(1600, 1440).clay, kBallRadius, (1.0 + by) * 5e6);
  const auto ratio = [&](double deep) {
    return length(clay.push({kLumpRadius + kBallRadius - deep, 0.1, 0})) /
           closed_form::light_force(kBallRadius, kLumpRadius, deep, 5e6);
  };
  // Off by depth over radius: so much less of half the depth.
  return std::fabs(2.0 * ratio(0.0002) - ratio(0.0004) - 1.0);
}

double a_flat_floor(double by) {
  FrozenClay clay(lone_lump(200, 360).clay, kBallRadius, (1.0 + by) * 5e6);
  return share_apart(clay.push({0, 0.010 + kBallRadius - 0.003, 0}).y,
                     closed_form::flat_force(kBallRadius, 0.003, 5e6));
}

ClayDef broad_lump() {
  ClayDef def = lone_wall(200, 360, 0.02, 0.12).clay;
  return def;
}

double a_flat_rim(double by) {
  const ClayDef def = broad_lump();
  FrozenClay clay(def, kBallRadius, (1.0 + by) * 5e6);
  return share_apart(clay.push({0.07, def.height + kBallRadius - 0.003, 0}).y,
                     closed_form::flat_force(kBallRadius, 0.003, 5e6));
}

// How far a flat place sinks, m, under a ball that was set down `deep` and is held for `seconds`,
// where it sinks by `rate(press left)` m/s. Heun's rule.
template <class Rate>
double sunk_under(double deep, double seconds, Rate&& rate) {
  constexpr int kParts = 2000;
  const double part = seconds / kParts;
  double left = deep;
  for (int n = 0; n < kParts; ++n) {
    const double first = rate(left);
    left -= 0.5 * part * (first + rate(left - part * first));
  }
  return deep - left;
}

double a_floor_off_the_axis(double by) {
  SceneDef def = lone_lump(200, 180);
  const double tau = def.contact.relaxation_time;
  def.contact.relaxation_time *= 1.0 + by;
  Scene scene = scene_of(def);
  const double off = 0.005;
  const Hands hands = ball_at({off, 0.010 + kBallRadius - 0.001, 0}, SideWish::inside);
  for (int n = 0; n < 20; ++n) scene.step(hands, kTickSeconds);
  const double should = sunk_under(0.001, 0.02, [&](double left) {
    const double print = std::sqrt(left * (2.0 * kBallRadius - left));
    const double share = print / (print + off);
    return left / tau * share * share;
  });
  return share_apart(0.010 - scene.clay().floor_top(), should);
}

double a_rim_that_sinks(double by) {
  SceneDef def = lone_lump(200, 180);
  def.clay = broad_lump();
  const double tau = def.contact.relaxation_time;
  def.contact.relaxation_time *= 1.0 + by;
  Scene scene = scene_of(def);
  const Hands hands = ball_at({0.07, def.clay.height + kBallRadius - 0.003, 0}, SideWish::outside);
  for (int n = 0; n < 50; ++n) scene.step(hands, kTickSeconds);
  const double ring = portable::kPi * (0.12 * 0.12 - 0.02 * 0.02);
  const double should = sunk_under(0.003, 0.05, [&](double left) {
    return closed_form::flat_force(kBallRadius, left, 1.0) / ring / tau;
  });
  return share_apart(def.clay.height - scene.clay().rim_height(), should);
}

// N: the greatest push on a flat rib that is 0.05 mm clear of the wall and rises past the rim.
double a_clear_rib(double by) {
  const ToolShape& rib = *find_tool_shape("flat_rib");
  ClayDef def = lone_wall(200, 180, 0.045, kLumpRadius).clay;
  Clay clay = std::move(*Clay::create(def));
  ToolSweep sweep;
  sweep.shape = &rib;
  sweep.size = sized(rib, {});
  const double middle = kLumpRadius + 0.5 * sweep.size.thickness + 5e-5;
  sweep.size.thickness *= 1.0 + by;
  sweep.across = {1, 0, 0};
  sweep.seconds = kTickSeconds;
  ToolContact contact;
  double most = 0.0;
  for (double up = 0.15; up < 0.26; up += 2e-4) {
    sweep.from = sweep.to = {middle, up, 0};
    contact.begin_tick();
    contact.step(clay, sweep, 0, 1, {0.00949, 5e6});
    most = std::max(most, length(contact.reaction().force));
  }
  return most;
}

// A wire through the solid foot, 1 mm a tick from outside to 25 mm from the axis.
template <class Each>
void draw_wire(const SceneDef& def, Each&& each) {
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.hand[0].tool = tool_of(def, "wire");
  hands.hand[0].handle = {0, 0, 1};
  for (double out = 0.065; out > 0.025; out -= 1e-4) {
    hands.hand[0].position = {out, 0.005, 0};
    each(out, scene.step(hands, kTickSeconds));
  }
}

double a_cut(double by) {
  SceneDef def = lone_lump(200, 360);
  def.clay.outer_radius *= 1.0 + by;
  double most = 0.0;
  draw_wire(def, [&](double out, const Feedback& felt) {
    const double c = std::min(out / kLumpRadius, 1.0);
    const double segment = 0.5 * portable::kPi - portable::asin(c) - c * std::sqrt(1.0 - c * c);
    most = std::max(most, std::fabs(felt.cut_free - segment / portable::kPi));
  });
  return most;
}

double a_wires_drag(double by) {
  SceneDef def = lone_lump(200, 1440);
  def.contact.stiffness *= 1.0 + by;
  double felt_sum = 0.0, law = 0.0;
  draw_wire(def, [&](double out, const Feedback& felt) {
    if (out > 0.045) return;
    felt_sum += felt.hand[0].force.x;
    // A strip 2 mm wide, pressed by 2 mm, as long as the chord before the wire.
    law += 5e6 * 0.002 * 0.002 * 2.0 * std::sqrt(kLumpRadius * kLumpRadius - out * out);
  });
  return share_apart(felt_sum, law);
}

constexpr const char* kTauKey = "contact.relaxation_time";
constexpr const char* kStiffnessKey = "contact.stiffness";

constexpr Witness kContact[] = {
    {"action and reaction", "k tau/dt A dr n of every element, added up from the radii", kTauKey,
     1e-5, "", clay_that_gives_way},
    {"a fresh wall's push", "k A l n of every element, added up in doubles", kStiffnessKey, 1e-5,
     "", a_fresh_wall},
    {"lightest touch", "Hertz's gap: k pi l^2 sqrt(a b)", kStiffnessKey, 5e-3, "", a_light_touch},
    {"held press", "a Maxwell element: l0 e^(-t/tau)", kTauKey, 2e-4, "", a_held_press},
    {"press at speed", "v tau (1 - e^(-t/tau))", kTauKey, 2e-3, "", a_press_at_speed},
    {"hole of a held ball", "the lens that ball and cylinder share", "tool.radius", 5e-4, "",
     a_hole},
    {"groove of many turns", "the ball's envelope", "tool.radius", 5e-5, "m", a_groove},
    {"floor's push", "k l n_y added up over rings of a flat face", kStiffnessKey, 1e-6, "",
     a_flat_floor},
    {"floor that sinks, off the axis", "dl/dt = -l/tau (a/(a+d))^2, solved by hand", kTauKey, 0.01,
     "", a_floor_off_the_axis},
    {"rim's push", "k l n_y added up over rings of a flat face", kStiffnessKey, 1e-6, "",
     a_flat_rim},
    {"rim that sinks", "dl/dt = -(sum of l n_y over rings) / (area tau), solved by hand", kTauKey,
     5e-3, "", a_rim_that_sinks},
    {"a tool that touches nothing", "no force: a rib 0.05 mm clear, past the rim",
     "flat_rib.thickness", 0.0, "N", a_clear_rib},
    {"wire's cut", "the segment of the circle that it has passed", "clay.outer_radius", 2e-4, "",
     a_cut},
    {"wire's drag", "4 mm^2 k times the chord before it", kStiffnessKey, 5e-3, "", a_wires_drag},
};

}  // namespace

std::span<const Witness> contact_witnesses() { return kContact; }

}  // namespace onggi::lab

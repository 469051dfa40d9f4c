#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/effects/propagation.h"
#include "engine/effects/smoothing.h"
#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"
#include "engine/math/unit.h"

// Written from engine/docs/effects.md.
namespace onggi::lab {
namespace {

constexpr double kEffectTick = 0.001;
constexpr double kFingerRadius = 0.008;

// Wetness that was `w` after `seconds` of drying, with a sponge or without: the one exponential.
double wetness_after(const MoistureDef& def, double w, double seconds, bool sponge,
                     bool fire = false) {
  const double soaking = sponge ? 1.0 / def.wetting_time : 0.0;
  const double drying = 1.0 / (fire ? def.fire_time : def.drying_time);
  const double pace = soaking + drying;
  const double end = (soaking + def.air * drying) / pace;
  return end + (w - end) * portable::exp(-pace * seconds);
}

void play(Scene& scene, const Hands& hands, double seconds) {
  for (long n = std::lround(seconds / kEffectTick); n > 0; --n) scene.step(hands, kEffectTick);
}

double soaked_and_dried(double by) {
  SceneDef def = lone_lump(40, 16);
  const MoistureDef law = def.moisture.emplace(MoistureDef{.drying_time = 20.0, .air = 0.1});
  def.moisture->drying_time *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands;
  double most = 0.0, w = 0.0;
  for (const auto& [seconds, sponge] : {std::pair{0.5, true}, {5.0, false}, {3.0, true}}) {
    hands.water = sponge;
    play(scene, hands, seconds);
    w = wetness_after(law, w, seconds, sponge);
    most = std::max(most, std::fabs(scene.wetness_of(20) - w));
  }
  return most;
}

double dried_by_a_fire(double by) {
  SceneDef def = lone_lump(40, 16);
  const MoistureDef law = def.moisture.emplace();
  def.moisture->fire_time *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands;
  double most = 0.0, w = 0.0;
  for (const auto& [seconds, sponge] : {std::pair{0.5, true}, {5.0, false}}) {
    hands.water = sponge;
    hands.fire = !sponge;
    play(scene, hands, seconds);
    w = wetness_after(law, w, seconds, hands.water, hands.fire);
    most = std::max(most, std::fabs(scene.wetness_of(20) - w));
  }
  return most;
}

// A sponge in one hand, at 5 cm; the other hand hovers with a rib at 15 cm.
double a_soaked_band(double by) {
  SceneDef def = lone_lump(200, 48);
  const MoistureDef law = def.moisture.emplace(MoistureDef{.sponge_height = 0.03});
  def.moisture->wetting_time *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.hand[0].tool = tool_of(def, "sponge");
  hands.hand[1] = hands.hand[0];
  hands.hand[1].tool = tool_of(def, "flat_rib");
  hands.hand[1].position = {0.165, 0.15, 0};
  constexpr int kTicks = 1000;
  for (int n = 0; n < kTicks; ++n) {
    hands.hand[0].position = {0.084 - 5e-6 * n, 0.05, 0};
    scene.step(hands, kEffectTick);
  }
  const auto at = [&](double height) {
    return scene.wetness_of(scene.clay().first_row_above(height));
  };
  // The first tick has not felt the clay yet.
  const double should = wetness_after(law, 0.0, (kTicks - 1) * kEffectTick, true);
  return std::max({std::fabs(at(0.05) - should), at(0.10), at(0.15)});
}

double soft_wet_clay(double by) {
  SceneDef def = lone_lump(200, 180);
  const MoistureDef law = def.moisture.emplace();
  def.moisture->softening *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands;
  hands.water = true;
  play(scene, hands, 0.6);
  const double w = wetness_after(law, 0.0, 0.6, true);
  const double tau = def.contact.relaxation_time * (1.0 + w * (law.softening - 1.0));
  const int row = scene.clay().first_row_above(0.1);
  const double out = 0.055 + kFingerRadius - 0.001;
  play(scene, ball_at(on_first_ray(scene.clay(), row, out), SideWish::outside), 0.01);
  return share_apart(double{scene.clay().outer(row)[0]} - (out - kFingerRadius),
                     0.001 * portable::exp(-0.01 / tau));
}

// The drag on a hand that is held to a wall that turns, against mu N v / sqrt(v^2 + eps^2) along
// the wall, with N from what the clay gave way in that tick.
double drag_apart(const SceneDef& def, const FrictionDef& law, double wheel) {
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = wheel;
  const auto come = [&](int tick) {
    hands.hand[0].position = {0.0631 - 1e-5 * std::min(tick, 150), 0.1, 0};
    return scene.step(hands, kEffectTick);
  };
  constexpr int kTicks = 220;
  for (int n = 0; n < kTicks; ++n) come(n);
  SceneDef lump = def;
  Clay before = std::move(*Clay::create(lump.clay));
  for (int j = 0; j < before.rows(); ++j)
    std::ranges::copy(scene.clay().outer(j), before.outer_mut(j).begin());
  const Feedback felt = come(kTicks);
  const Vec3 hand = hands.hand[0].position;
  // In the clay's frame, in the middle of the tick.
  const double angle = felt.clay_angle - 0.5 * wheel * kEffectTick;
  const double c = portable::cos(angle), s = portable::sin(angle);
  const double normal =
      taken_press(before, scene.clay(), WallSide::outside,
                  {hand.x * c + hand.z * s, hand.y, hand.z * c - hand.x * s}, 2.0 * kFingerRadius,
                  def.contact.stiffness, def.contact.relaxation_time / kEffectTick)
          .normal;
  const Vec3 push = felt.hand[0].touch.push;
  const Vec3 out = unit(push);
  const Vec3 touch = hand - kFingerRadius * out;
  const Vec3 slip{wheel * touch.z, 0.0, -wheel * touch.x};  // of the hand, less the clay's
  const Vec3 along = slip - dot(slip, out) * out;
  const double speed = std::sqrt(dot(along, along) + law.slip_speed * law.slip_speed);
  const Vec3 should = (-law.coefficient * normal / speed) * along;
  return length(felt.hand[0].force - push - should) / length(should);
}

double friction_either_way(double by) {
  SceneDef def = lone_lump(200, 360);
  const FrictionDef law = def.friction.emplace();
  def.friction->coefficient *= 1.0 + by;
  return std::max(drag_apart(def, law, 10.0), drag_apart(def, law, -10.0));
}

double friction_near_rest(double by) {
  SceneDef def = lone_lump(200, 360);
  const FrictionDef law = def.friction.emplace();
  def.friction->slip_speed *= 1.0 + by;
  return drag_apart(def, law, 0.2);
}

// One row of a solid-walled tube, pressed by 0.5 mm all round, and what it drags along.
double a_dragged_wall(double by) {
  ClayDef def = lone_lump(200, 16).clay;
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  clay.keep_areas();
  clay.keep_displacements();
  constexpr int kPressed = 100;
  constexpr float kBy = 5e-4f;
  for (std::size_t i = 0; i < clay.outer(kPressed).size(); ++i) {
    clay.outer_mut(kPressed)[i] -= kBy;
    clay.displacements(false)->row(kPressed)[i] = kBy;
  }
  clay.areas()->set(kPressed, clay.measured_area(kPressed));
  clay.displacements(false)->mark(kPressed, {0, clay.stride() / Displacements::kBlock});
  PropagationDef pull;
  const double reach = pull.reach;
  pull.reach *= 1.0 + by;
  effects::Propagation(clay.rows()).drag(pull, clay, WallSide::outside, 0.0);
  double most = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    const double apart = std::fabs(clay.row_height(j) - clay.row_height(kPressed));
    const double last = portable::exp(-3.0);
    const double share =
        apart < 3.0 * reach ? (portable::exp(-apart / reach) - last) / (1.0 - last) : 0.0;
    const double moved = def.outer_radius - double{clay.outer(j)[3]};
    most = std::max(most, std::fabs(moved / double{kBy} - share));
  }
  return most;
}

// What comes back in 0.2 s of a dent that was pressed for 0.1 s, against the standard linear solid:
// x' = l / tau - u / time, u' = share l / tau - u / time, l what is left of the press.
double what_comes_back(double by) {
  SceneDef def = lone_lump(200, 180);
  const SpringbackDef law = def.springback.emplace(SpringbackDef{.share = 0.3});
  def.springback->share *= 1.0 + by;
  Scene scene = scene_of(def);
  const int row = scene.clay().first_row_above(0.1);
  Hands hands =
      ball_at(on_first_ray(scene.clay(), row, 0.055 + kFingerRadius - 0.001), SideWish::outside);
  play(scene, hands, 0.1);
  const double pressed = double{scene.clay().outer(row)[0]};
  hands.hand[0].active = false;
  play(scene, hands, 0.2);
  const double came = double{scene.clay().outer(row)[0]} - pressed;

  constexpr double kPart = 1e-5;
  double dent = 0.0, elastic = 0.0;
  for (double t = 0.0; t < 0.1; t += kPart) {
    const double gives = std::max(0.001 - dent, 0.0) / def.contact.relaxation_time;
    dent += kPart * (gives - elastic / law.time);
    elastic += kPart * (law.share * gives - elastic / law.time);
  }
  return share_apart(came, elastic * (1.0 - portable::exp(-0.2 / law.time)));
}

// Lines that are a mode of R^2's diffusion between two closed ends fade by 1 / (1 + pace lambda dt)
// in each tick.
double lines_that_fade(double by) {
  ClayDef def = lone_lump(200, 24).clay;
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  clay.keep_areas();
  clay.keep_displacements();
  constexpr int kLow = 50, kCount = 100, kWaves = 20, kTicks = 20;
  constexpr double kFace = 0.053, kDeep = 1e-4;
  const double row = clay.first_thickness(), turn = portable::kPi * kWaves / kCount;
  const auto square = [&](int k, double left) {
    return kFace * kFace + 2.0 * kFace * kDeep * left * portable::cos(turn * (k + 0.5));
  };
  for (int j = 0; j < clay.rows(); ++j) {
    const int k = std::clamp(j - kLow, 0, kCount - 1);
    std::ranges::fill(clay.outer_mut(j), static_cast<float>(std::sqrt(square(k, 1.0))));
    clay.areas()->set(j, clay.measured_area(j));
  }
  SmoothingDef even;
  const double lambda = (2.0 - 2.0 * portable::cos(turn)) / (row * row);
  const double each = 1.0 / (1.0 + even.pace * lambda * kEffectTick);
  even.pace *= 1.0 + by;
  double left = 1.0;
  for (int n = 0; n < kTicks; ++n) {
    for (int j = 0; j < clay.rows(); ++j) {
      clay.displacements(false)->mark(j, {0, 3});
      std::fill_n(clay.displacements(false)->row(clay.stored(j)), clay.sectors(), 1e-6f);
    }
    effects::Smoothing smoothing(clay.rows());
    smoothing.even(even, clay, WallSide::outside, kLow * row, (kLow + kCount) * row, kEffectTick);
    clay.displacements(false)->clear(clay.stored());
    left *= each;
  }
  double most = 0.0;
  for (int k = 0; k < kCount; ++k)
    most = std::max(most, std::fabs(double{clay.outer(kLow + k)[5]} - std::sqrt(square(k, left))));
  return most / ((1.0 - left) * kDeep);
}

double an_off_centre_lump(double by) {
  SceneDef def = lone_lump(100, 96);
  const double off = def.wobble.emplace().off_centre;
  def.wobble->off_centre *= 1.0 + by;
  const Scene scene = scene_of(def);
  double most = 0.0;
  for (int i = 0; i < def.clay.sectors; ++i) {
    const double angle = (i + 0.5) * 2.0 * portable::kPi / def.clay.sectors;
    const auto circle = [&](double radius) {
      const double aside = off * portable::sin(angle);
      return off * portable::cos(angle) + std::sqrt(radius * radius - aside * aside);
    };
    const auto n = static_cast<std::size_t>(i);
    most = std::max({most, std::fabs(double{scene.clay().outer(50)[n]} - circle(0.055)),
                     std::fabs(double{scene.clay().inner(50)[n]} - circle(0.022))});
  }
  return most;
}

// Angle by which a beat of five turns is ahead of the wheel's in the next five.
double a_beat(double by) {
  SceneDef def = lone_lump(100, 180);
  def.contact.relaxation_time = 1.0;
  def.wobble.emplace(WobbleDef{.off_centre = 0.001, .centring_time = 60.0});
  Scene scene = scene_of(def);
  Hands hands = ball_at({0.055 + kFingerRadius - 0.002, 0.1, 0}, SideWish::outside);
  const double wheel = 12.0;
  hands.wheel_speed = (1.0 + by) * wheel;
  play(scene, hands, 0.2);
  const double turn = 2.0 * portable::kPi / wheel;
  const int ticks = static_cast<int>(std::lround(5.0 * turn / kEffectTick));
  std::array<double, 2> phase{};
  int n = 0;
  for (double& of : phase) {
    double c = 0.0, s = 0.0;
    for (int k = 0; k < ticks; ++k, ++n) {
      const double push = scene.step(hands, kEffectTick).hand[0].touch.push.x;
      c += push * portable::cos(wheel * kEffectTick * n);
      s += push * portable::sin(wheel * kEffectTick * n);
    }
    of = portable::atan2(s, c);
  }
  double ahead = phase[1] - phase[0];
  ahead -= 2.0 * portable::kPi * std::round(ahead / (2.0 * portable::kPi));
  return std::fabs(ahead) / (wheel * ticks * kEffectTick);
}

// First harmonic of a row's outline towards angle 0, m.
double off_towards_x(const Clay& clay, int row) {
  double sum = 0.0;
  for (std::size_t i = 0; i < clay.outer(row).size(); ++i)
    sum += double{clay.outer(row)[i]} *
           portable::cos((static_cast<double>(i) + 0.5) * 2.0 * portable::kPi / clay.sectors());
  return 2.0 * sum / clay.sectors();
}

// 20 mm above a hand that pushes the high side of a wheel that stands.
double a_lump_that_is_centred(double by) {
  SceneDef def = lone_lump(200, 96);
  def.contact.relaxation_time = 0.1;
  def.friction.emplace();
  const WobbleDef law = def.wobble.emplace();
  def.wobble->centring_time *= 1.0 + by;
  Scene scene = scene_of(def);
  const int row = scene.clay().first_row_above(0.12);
  const double away = (scene.clay().row_height(row) - 0.1) / law.reach;
  const double before = off_towards_x(scene.clay(), row);
  double impulse = 0.0;  // N s
  Hands hands = ball_at({}, SideWish::outside);
  for (int n = 0; n < 150; ++n) {
    hands.hand[0].position = {0.0592 + kFingerRadius - 2e-5 * n, 0.1, 0};
    impulse +=
        scene.step(hands, kEffectTick).hand[0].touch.grip / def.friction->coefficient * kEffectTick;
  }
  hands.hand[0].active = false;
  play(scene, hands, 0.2);
  const double should = impulse / law.centring_time * (1.0 - away * away);
  return share_apart(portable::log(before / off_towards_x(scene.clay(), row)), should);
}

double fired(double by) {
  double most = 0.0;
  for (const auto& [body, drying, firing, total] : {std::tuple{"earthenware", 0.06, 0.0426, 0.10},
                                                    {"stoneware", 0.0625, 0.0666, 0.125},
                                                    {"porcelain", 0.06, 0.117, 0.17}}) {
    const ClayBody* clay = find_clay_body(body);
    if (clay == nullptr) return HUGE_VAL;
    const KilnDef def{.drying_shrinkage = (1.0 + by) * clay->drying_shrinkage,
                      .firing_shrinkage = clay->firing_shrinkage};
    const double size = size_after(def, {.dried = 1.0, .fired = 1.0});
    most = std::max(
        {most, std::fabs(size - (1.0 - drying) * (1.0 - firing)), std::fabs(1.0 - size - total)});
  }
  return most;
}

constexpr Witness kEffects[] = {
    {"drag of a wall that turns, either way",
     "mu N v / sqrt(v^2 + eps^2), N added up from the radii", "friction.coefficient", 1e-5, "",
     friction_either_way},
    {"drag near rest", "mu N v / sqrt(v^2 + eps^2) at 11 mm/s", "friction.slip_speed", 1e-3, "",
     friction_near_rest},
    {"soaking and drying", "one exponential of both", "moisture.drying_time", 1e-12, "",
     soaked_and_dried},
    {"drying by a fire in the pot", "one exponential of fire_time", "moisture.fire_time", 1e-12, "",
     dried_by_a_fire},
    {"a sponge's band", "one exponential at the sponge, 0 elsewhere and at the other hand",
     "moisture.wetting_time", 1e-12, "", a_soaked_band},
    {"wet clay gives way sooner", "a Maxwell element of tau (1 + w (softening - 1))",
     "moisture.softening", 2e-4, "", soft_wet_clay},
    {"what a press drags along", "(e^(-z/reach) - e^-3) / (1 - e^-3)", "propagation.reach", 2e-5,
     "", a_dragged_wall},
    {"what comes back", "a standard linear solid, solved by hand", "springback.share", 0.04, "",
     what_comes_back},
    {"lines under a rib", "a mode of R^2 that fades by 1 / (1 + pace lambda dt)", "smoothing.pace",
     2e-4, "", lines_that_fade},
    {"a lump off the middle", "e cos a + sqrt(R^2 - e^2 sin^2 a)", "wobble.off_centre", 1e-8, "m",
     an_off_centre_lump},
    {"the beat of a lump off the middle", "once a turn: the phase of ten turns",
     "the wheel's speed", 1e-4, "", a_beat},
    {"the centring of a lump off the middle", "ln(m0/m1) = (1 - (z/reach)^2) sum of N dt / T",
     "wobble.centring_time", 1e-5, "", a_lump_that_is_centred},
    {"shrinking in the kiln", "products of the table's two shares: 10, 12.5, 17 %",
     "kiln.drying_shrinkage", 1e-4, "", fired},
};

}  // namespace

std::span<const Witness> effect_witnesses() { return kEffects; }

}  // namespace onggi::lab

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/lab/trial.h"
#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"

// Of the clay as a whole: balances, and symmetries that nobody has put in. Written from
// engine/docs/clay.md, effects.md (volume) and tools.md.
namespace onggi::lab {
namespace {

constexpr double kHandRadius = 0.008;
constexpr double kClayTick = 0.001;

double pot_volume(double height, double floor, double inner, double outer) {
  return portable::kPi * (outer * outer * height - inner * inner * (height - floor));
}

double clay_that_is_kept(double by) {
  SceneDef def = lone_wall(200, 180, 0.045, 0.055);
  def.volume.emplace();
  def.walls.emplace();
  const double should = pot_volume(0.2, 0.010, 0.045, 0.055);
  def.clay.outer_radius *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = 18.0;
  hands.hand[1] = hands.hand[0];
  hands.hand[1].side = SideWish::inside;
  for (int n = 0; n < 3000; ++n) {
    // Pulled up between two hands, then pressed down on the rim.
    const double off = 0.005 + kHandRadius - 1e-6 * std::min(n, 1500);
    hands.hand[0].position = {0.050 + off, 0.05 + 2e-5 * std::min(n, 1500), 0};
    hands.hand[1].position = {0.050 - off, 0.05 + 2e-5 * std::min(n, 1500), 0};
    hands.hand[1].active = n < 1500;
    if (n >= 1500) {
      hands.hand[0].active = n > 1700;
      hands.hand[0].position = {0.05, scene.clay().rim_height() + kHandRadius - 0.002, 0};
    }
    scene.step(hands, kClayTick);
  }
  return share_apart(volume_of(scene.clay()), should);
}

// A loop, or a finger in its place, that goes from `from` by `way` in two seconds.
Scene cut_by(double by, double inner, Vec3 from, Vec3 way) {
  SceneDef def = lone_wall(200, 180, inner, 0.055);
  def.volume.emplace();
  Scene scene = scene_of(def);
  Hands hands = ball_at(from, SideWish::by_position);
  hands.wheel_speed = 18.0;
  hands.hand[0].tool = tool_of(def, by > 0.0 ? "fingertip" : "loop_trimmer");
  for (int n = 0; n < 2500; ++n) {
    hands.hand[0].position = from + std::min(n / 2000.0, 1.0) * way;
    scene.step(hands, kClayTick);
  }
  hands.hand[0].active = false;
  for (int n = 0; n < 300; ++n) scene.step(hands, kClayTick);
  return scene;
}

// What is missing of each row, of a pot whose rows are as high as they were.
double hole_of(const Clay& clay, double inner) {
  double hole = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    const double kept = clay.row_height(j) < 0.010 ? 0.0 : inner;
    hole += (portable::kPi * (0.055 - kept) * (0.055 + kept) - row_area_of(clay, j)) * 0.2 / 200.0;
  }
  return hole;
}

double gone_of(const Clay& clay, double inner) {
  return pot_volume(0.2, 0.010, inner, 0.055) - volume_of(clay);
}

double trimmed_wall(double by) {
  const Scene scene = cut_by(by, 0.03, {0.055 + 0.009, 0.1, 0}, {-0.004, 0, 0});
  const Clay& clay = scene.clay();
  return share_apart(gone_of(clay, 0.03), hole_of(clay, 0.03));
}

double trimmed_floor(double by) {
  const Scene scene = cut_by(by, 0.03, {0, 0.010 + 0.009, 0}, {0, -0.013, 0});
  const Clay& clay = scene.clay();
  return share_apart(gone_of(clay, 0.03), hole_of(clay, 0.03));
}

double trimmed_rim(double by) {
  const Scene scene = cut_by(by, 0.045, {0.05, 0.2 + 0.009, 0}, {0, -0.012, 0});
  const double ring = portable::kPi * (0.055 * 0.055 - 0.045 * 0.045);
  return share_apart(gone_of(scene.clay(), 0.045), ring * (0.2 - scene.clay().rim_height()));
}

// m: how far any radius or row is from the lump's, once the only stroke is taken back.
double taken_back(double by) {
  SceneDef def = lone_wall(200, 96, 0.045, 0.055);
  def.clay.keep_undo = true;
  def.volume.emplace();
  def.walls.emplace();
  def.clay.outer_radius *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = 12.0;
  for (int n = 0; n < 1500; ++n) {
    hands.hand[0].position = {def.clay.outer_radius + kHandRadius - 5e-6 * n, 0.1, 0};
    hands.hand[0].active = n < 800;
    scene.step(hands, kClayTick);
  }
  const bool pressed = scene.clay().hash() != scene_of(def).clay().hash();
  hands.restore = true;
  scene.step(hands, kClayTick);
  hands.restore = false;
  for (int n = 0; n < 2000 && scene.laying(); ++n) scene.step(hands, kClayTick);
  const Clay& clay = scene.clay();
  if (!pressed || clay.rows() != 200) return HUGE_VAL;
  double most = 0.0;
  for (int j = 0; j < clay.rows(); ++j) {
    const double kept = clay.row_height(j) < 0.010 ? 0.0 : 0.045;
    most = std::max(most, std::fabs(clay.row_height(j) - (j + 0.5) * 0.001));
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i)
      most = std::max({most, std::fabs(double{clay.outer(j)[i]} - double{0.055f}),
                       std::fabs(double{clay.inner(j)[i]} - double{static_cast<float>(kept)})});
  }
  return most;
}

// What a stroke with both hands leaves, and is felt as.
struct Stroked {
  std::vector<Vec3> push;       // of hand 0 and 1 in turn, N
  std::vector<double> outline;  // mean radii of each row, m
};

SceneDef stroked_wall() {
  SceneDef def = lone_wall(200, 180, 0.045, 0.055);
  def.walls.emplace();
  def.volume.emplace();
  return def;
}

// `turned`: the hands as they are, turned, mirrored or scaled.
template <class Turned>
Stroked stroke(const SceneDef& def, Turned&& turned) {
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = 10.0;
  hands.hand[1] = hands.hand[0];
  hands.hand[1].side = SideWish::inside;
  Stroked left;
  for (int n = 0; n < 800; ++n) {
    const double in = 1e-5 * std::min(n, 250), up = 0.1 + 3e-5 * std::max(n - 250, 0);
    hands.hand[0].position = {0.0555 + kHandRadius - in, up, 0.003};
    hands.hand[1].position = {0.0455 - kHandRadius, up - 0.004, -0.002};
    const Feedback felt = scene.step(turned(hands), kClayTick);
    for (const HandFeedback& hand : felt.hand) left.push.push_back(hand.touch.push);
  }
  for (int j = 0; j < scene.clay().rows(); ++j) {
    double outer = 0.0, inner = 0.0;
    for (std::size_t i = 0; i < scene.clay().outer(j).size(); ++i) {
      outer += double{scene.clay().outer(j)[i]};
      inner += double{scene.clay().inner(j)[i]};
    }
    left.outline.push_back(outer / def.clay.sectors);
    left.outline.push_back(inner / def.clay.sectors);
  }
  return left;
}

// The larger of the pushes' difference, as a share of the largest, and the outlines', as a share of
// a millimetre. `back` turns a push back.
template <class Back>
double strokes_apart(const Stroked& one, const Stroked& other, double scale, Back&& back) {
  if (one.outline.size() != other.outline.size()) return HUGE_VAL;
  double push = 0.0, largest = 0.0, outline = 0.0;
  for (std::size_t n = 0; n < one.push.size(); ++n) {
    push = std::max(push, length(one.push[n] - back(other.push[n])));
    largest = std::max(largest, length(one.push[n]));
  }
  for (std::size_t n = 0; n < one.outline.size(); ++n)
    outline = std::max(outline, std::fabs(one.outline[n] - scale * other.outline[n]));
  return std::max(push / largest, outline / 0.001);
}

double turned_by_a_quarter(double by) {
  SceneDef def = stroked_wall();
  const Stroked one = stroke(def, [](const Hands& hands) { return hands; });
  def.contact.stiffness *= 1.0 + by;
  const Stroked other = stroke(def, [](Hands hands) {
    for (HandInput& hand : hands.hand)
      hand.position = {-hand.position.z, hand.position.y, hand.position.x};
    return hands;
  });
  return strokes_apart(one, other, 1.0, [](Vec3 push) { return Vec3{push.z, push.y, -push.x}; });
}

double in_a_mirror(double by) {
  SceneDef def = stroked_wall();
  const Stroked one = stroke(def, [](const Hands& hands) { return hands; });
  def.contact.stiffness *= 1.0 + by;
  const Stroked other = stroke(def, [](const Hands& hands) { return mirrored(hands); });
  return strokes_apart(one, other, 1.0, [](Vec3 push) { return Vec3{push.x, push.y, -push.z}; });
}

void double_lengths(ClayDef& clay) {
  for (double* each : {&clay.height, &clay.outer_radius, &clay.inner_radius, &clay.floor_thickness,
                       &clay.floor_min, &clay.wall_min, &clay.radius_min, &clay.radius_max})
    *each *= 2.0;
}

double twice_as_large(double by) {
  SceneDef def = stroked_wall();
  const Stroked one = stroke(def, [](const Hands& hands) { return hands; });
  double_lengths(def.clay);
  def.tool.radius *= 2.0;
  def.walls->support *= 2.0;
  def.contact.stiffness *= 1.0 + by;
  const Stroked other = stroke(def, [](Hands hands) {
    for (HandInput& hand : hands.hand) hand.position = 2.0 * hand.position;
    return hands;
  });
  return strokes_apart(one, other, 0.5, [](Vec3 push) { return 0.125 * push; });
}

// Share of its height that a tube sags by in two seconds.
double sagged_share(const SceneDef& def) {
  Scene scene = scene_of(def);
  for (int n = 0; n < 2000; ++n) scene.step({}, kClayTick);
  return 1.0 - scene.clay().rim_height() / def.clay.height;
}

double sags_twice_as_large(double by) {
  SceneDef def = lone_wall(100, 16, 0.045, 0.055);
  def.clay.floor_thickness = 0.0;
  def.volume.emplace();
  def.slump.emplace().yield_stress = 1000.0;
  const double one = sagged_share(def);
  double_lengths(def.clay);
  def.slump->viscosity *= 2.0;
  def.slump->yield_stress *= 2.0 * (1.0 + by);
  return share_apart(sagged_share(def), one);
}

constexpr Witness kClay[] = {
    {"clay that is kept", "the fresh pot's volume, pi (R^2 H - r^2 (H - floor))",
     "clay.outer_radius", 1e-6, "", clay_that_is_kept},
    {"trimmed wall", "what is gone is the hole that is left; nothing rises", "the tool: a finger",
     1e-8, "", trimmed_wall},
    {"trimmed floor", "what is gone is the hole that is left; nothing rises", "the tool: a finger",
     1e-8, "", trimmed_floor},
    {"trimmed rim", "what is gone is the ring's area times how far the rim sank",
     "the tool: a finger", 2e-3, "", trimmed_rim},
    {"a stroke that is taken back", "the fresh lump", "clay.outer_radius", 1e-9, "m", taken_back},
    {"turned by a quarter", "both hands' pushes and the outline, turned", "contact.stiffness", 1e-7,
     "", turned_by_a_quarter},
    {"in a mirror, wheel reversed", "both hands' pushes and the outline, mirrored",
     "contact.stiffness", 1e-10, "", in_a_mirror},
    {"twice as large", "pushes 8 times as large, lengths twice", "contact.stiffness", 2e-5, "",
     twice_as_large},
    {"sagging, twice as large", "tau_y and eta twice: the same share of its height",
     "slump.yield_stress", 1e-6, "", sags_twice_as_large},
};

}  // namespace

std::span<const Witness> clay_witnesses() { return kClay; }

}  // namespace onggi::lab

#include "engine/lab/accuracy_script.h"

#include <algorithm>
#include <cmath>

#include "engine/lab/scene_fields.h"
#include "engine/lab/scene_work.h"
#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kClear = 0.001;  // m: where a hand begins and ends
constexpr double kBelly = 0.085,
                 kVase = 0.13;      // m: how high the vase is widest, from waist to waist
constexpr double kMiddle = 0.1003;  // m: on no grid's row, nor between two

// Nothing but contact, with a guard that leaves forces alone once the hand has arrived.
SceneDef bench_scene() {
  SceneDef def = bare({});
  def.clay.keep_undo = false;
  def.wheel.acceleration = 1000.0;
  def.guard = {22.0, 1e5, 0.05};
  return def;
}

AccuracyScript script(std::string name, std::string words, SceneDef def) {
  AccuracyScript out;
  out.name = std::move(name);
  out.words = std::move(words);
  out.def = std::move(def);
  return out;
}

// A ball on a face, `deep` into it.
AccuracyScript::Hand ball_on(const SceneDef& def, WallSide side, double deep, double angle,
                             double from, double to) {
  const bool outside = side == WallSide::outside;
  const double face = outside ? def.clay.outer_radius : def.clay.inner_radius;
  const double away = outside ? 1.0 : -1.0;
  AccuracyScript::Hand hand;
  hand.side = side;
  hand.angle = angle;
  hand.clear = face + away * (def.tool.radius + kClear);
  hand.deep = face + away * (def.tool.radius - deep);
  hand.from = from;
  hand.to = to;
  return hand;
}

// Rows that are touched, and a few millimetres that stay as they were.
void frame(AccuracyScript& script) {
  script.low = 1.0;
  for (const AccuracyScript::Hand& hand : script.balls) {
    script.low = std::min(script.low, std::min(hand.from, hand.to));
    script.high = std::max(script.high, std::max(hand.from, hand.to));
  }
  script.low -= script.def.tool.radius + 0.006;
  script.high += script.def.tool.radius + 0.006;
}

}  // namespace

Vec3 AccuracyScript::place(std::size_t n, double t) const {
  const Hand& hand = balls[n];
  const double share = t / seconds;
  double in = eased((share - 0.05) / (hand.in_by - 0.05));
  if (hand.out_from < 1.0) in -= eased((share - hand.out_from) / (0.95 - hand.out_from));
  const double height = hand.from + (hand.to - hand.from) * eased(share);
  const double wave = portable::cos(2.0 * portable::kPi * (height - kBelly) / kVase);
  const double deep = hand.deep + 0.5 * (1.0 + wave) * hand.belly;
  const double d = hand.clear + in * (deep - hand.clear);
  return {d * portable::cos(hand.angle), height, d * portable::sin(hand.angle)};
}

Hands AccuracyScript::hands(double t) const {
  Hands out;
  out.wheel_speed = wheel;
  for (std::size_t n = 0; n < balls.size(); ++n) {
    HandInput& hand = out.hand[n];
    hand.active = true;
    hand.position = place(n, t);
    hand.side = balls[n].side == WallSide::outside ? SideWish::outside : SideWish::inside;
  }
  return out;
}

double AccuracyScript::wheel_angle(double t) const {
  const double full_at = wheel / def.wheel.acceleration;
  return t < full_at ? 0.5 * def.wheel.acceleration * t * t : wheel * (t - 0.5 * full_at);
}

bool AccuracyScript::works(WallSide side) const {
  return std::ranges::any_of(balls, [side](const Hand& hand) { return hand.side == side; });
}

std::vector<AccuracyScript> accuracy_scripts() {
  constexpr WallSide out = WallSide::outside, in = WallSide::inside;
  const SceneDef lump = bench_scene();
  std::vector<AccuracyScript> all;

  all.push_back(script("press", "a fingertip 1.5 mm into the turning wall, and out", lump));
  all.back().balls = {ball_on(lump, out, 0.0015, 0.0, kMiddle, kMiddle)};

  SceneDef wall = lump;
  wall.clay.inner_radius = 0.045;
  all.push_back(script("pull", "two hands, one on either face, rise by 30 mm", wall));
  all.back().balls = {ball_on(wall, out, 0.001, 0.0, kMiddle - 0.015, kMiddle + 0.015),
                      ball_on(wall, in, 0.001, 0.0, kMiddle - 0.015, kMiddle + 0.015)};

  all.push_back(script("groove", "a fingertip held 2 mm deep for seven turns", lump));
  all.back().balls = {ball_on(lump, out, 0.002, 0.0, kMiddle, kMiddle)};
  all.back().balls[0].in_by = 0.3;
  all.back().balls[0].out_from = 1.0;
  all.back().wheel = 31.4;
  all.back().seconds = 1.4;

  all.push_back(script("collar", "both hands outside, opposite, 2 mm in and up by 20 mm", lump));
  all.back().balls = {ball_on(lump, out, 0.002, 0.0, kMiddle - 0.01, kMiddle + 0.01),
                      ball_on(lump, out, 0.002, portable::kPi, kMiddle - 0.01, kMiddle + 0.01)};
  all.back().wheel = 18.0;

  SceneDef solid = lump;
  solid.clay.floor_thickness = solid.clay.height;
  solid.tool.radius = 0.02;
  all.push_back(script("centre", "two palms 4 mm into a solid lump at 300 rpm", solid));
  all.back().balls = {ball_on(solid, out, 0.004, 0.4, kMiddle, kMiddle),
                      ball_on(solid, out, 0.004, 2.7, kMiddle, kMiddle)};
  all.back().wheel = 31.4;

  SceneDef narrow = lump;
  narrow.clay.inner_radius = 0.01;
  all.push_back(script("near_axis", "a hole of 1 cm is opened, the ball about the axis", narrow));
  all.back().balls = {ball_on(narrow, in, 0.002, 0.0, kMiddle, kMiddle)};

  SceneDef broad = lump;
  broad.tool.radius = 0.012;
  all.push_back(script("throw", "a vase: one slow rise of a knuckle, at 300 rpm", broad));
  all.back().balls = {ball_on(broad, out, 0.015, 0.0, 0.03, 0.168)};
  all.back().balls[0].belly = 0.0125;
  all.back().balls[0].in_by = 0.2;
  all.back().balls[0].out_from = 0.8;
  all.back().wheel = 31.4;
  all.back().seconds = 4.0;

  for (AccuracyScript& each : all) frame(each);
  return all;
}

}  // namespace onggi::lab

#include "engine/script/upright.h"

#include <algorithm>
#include <array>

namespace onggi::script {
namespace {

constexpr double kToolClear = 0.003;  // m between a tool and the clay it is not to touch yet
constexpr double kDown = 0.015;       // m/s, pressing down
constexpr double kAlong = 0.010;      // m/s, along the floor and the rim
constexpr double kUp = 0.007;         // m/s, up the wall: slow enough for the clay to follow
constexpr double kLifting = 0.05;     // m/s, off the clay

}  // namespace

void open_up(Choreography& hand, Former&, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  const double over = clay.height + radius + kToolClear;
  const double floor = std::min(std::max(clay.floor_min, 0.006), clay.floor_thickness);
  const double deep = floor + radius;
  const double wide =
      std::max(clay.inner_radius, clay.outer_radius - 2.0 * clay.wall_min - 0.002) - radius;
  hand.carry(WallSide::inside, {0.0, over}, clay.height, clay.outer_radius, radius);
  hand.phase("open");
  hand.glide(std::array<Vec2, 1>{Vec2{0.0, deep}}, kDown);
  hand.glide(std::array<Vec2, 1>{Vec2{std::max(wide, 0.0), deep}}, kAlong);
  hand.wait_turns(2.0);
  hand.phase("pull");
  hand.glide(std::array<Vec2, 1>{Vec2{std::max(wide, 0.0), clay.height}}, kUp);
  hand.wait_turns(1.0);
}

void press_lip(Choreography& hand, Former&, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  const double middle = 0.5 * (clay.outer_radius + clay.inner_radius);
  const double over = clay.height + radius + kToolClear;
  hand.carry(WallSide::outside, {middle, over}, clay.height, clay.outer_radius, radius);
  hand.phase("press_rim");
  hand.glide(std::array<Vec2, 1>{Vec2{middle, clay.height + radius - 0.05 * clay.height}},
             0.3 * kDown);
  hand.wait_turns(6.0);
  hand.raise(0.05 * clay.height + 2.0 * kToolClear, kLifting);
}

void flare_lip(Choreography& hand, Former&, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  const double begin = std::max(clay.inner_radius - 0.4 * radius, 0.0);
  const double low = clay.height + 0.4 * radius;
  hand.carry(WallSide::inside, {begin, clay.height + radius + kToolClear}, clay.height,
             clay.outer_radius, radius);
  hand.phase("flare_rim");
  hand.glide(std::array<Vec2, 2>{Vec2{begin, low}, Vec2{begin + radius, low}}, 0.3 * kAlong);
  hand.wait_turns(4.0);
  hand.raise(radius, kLifting);
}

void squeeze_wall(Choreography& hand, Former&, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  const double wall = clay.outer_radius - clay.inner_radius;
  const double foot = clay.floor_thickness + 1.2 * radius;
  const double thin = std::max(clay.wall_min, wall - std::min(wall / 3.0, 0.006));
  hand.carry(WallSide::outside, {clay.outer_radius + radius + kToolClear, foot}, clay.height,
             clay.outer_radius, radius);
  hand.phase("squeeze");
  hand.grip(wall + 2.0 * kToolClear, 0.0);
  hand.grip(thin, 1.0);
  hand.wait_turns(2.0);
  const double outer = clay.outer_radius + radius - 0.5 * (wall - thin);
  hand.glide(std::array<Vec2, 1>{Vec2{outer, clay.height - 0.2 * radius}}, kUp);
  hand.wait_turns(1.0);
}

}  // namespace onggi::script

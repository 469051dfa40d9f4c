// What a round tool feels near the rim's crown does not step, on either face.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/scene/scene.h"

namespace onggi::felt_rim_steps_test {
namespace {

// The largest change of a ball's push over two micrometres as it goes up along a face of frozen
// clay, from 8 mm below the crown to 1 mm above it, `depth` m deep. N.
double largest_step(SceneDef def, double radius, double depth, bool inside) {
  def.contact.relaxation_time = 1.0;
  def.moisture.reset();
  def.friction.reset();
  def.clay.keep_undo = false;
  def.clay.rows = 200;
  def.clay.sectors = 128;
  def.tool.radius = radius;
  auto scene = Scene::create(def);
  EXPECT_TRUE(scene);
  if (!scene) return 1e9;
  const double from = def.clay.height - 0.008;
  const double x =
      inside ? def.clay.inner_radius - radius + depth : def.clay.outer_radius + radius - depth;
  Hands hands;
  hands.hand[0] = {.position = {x, from, 0.001},
                   .active = true,
                   .side = inside ? SideWish::inside : SideWish::by_position};
  constexpr double kFrozen = 1e-6;  // s a tick: a millionth of what clay takes to give way
  for (int rest = 0; rest < 3; ++rest) scene->step(hands, kFrozen);
  double largest = 0.0;
  Vec3 before = scene->step(hands, kFrozen).hand[0].touch.push;
  for (int um = 1; um <= 9000; um += 2) {
    hands.hand[0].position.y = from + 1e-6 * um;
    const Vec3 now = scene->step(hands, kFrozen).hand[0].touch.push;
    largest = std::max(largest, length(now - before));
    before = now;
  }
  return largest;
}

constexpr double kNoStep =
    0.002;  // N over two micrometres: less than engine/docs/contact.md promises

TEST(FeltRimSteps, ABallThatGoesUpTheInnerFaceFeelsNoStep) {
  for (const double wall : {0.006, 0.033})
    for (const double depth : {0.002, 0.005}) {
      SceneDef def;
      def.clay.wall_min = 0.002;
      def.clay.inner_radius = def.clay.outer_radius - wall;
      EXPECT_LT(largest_step(def, 0.008, depth, true), kNoStep) << wall << ' ' << depth;
      EXPECT_LT(largest_step(def, 0.008, depth, false), kNoStep) << wall << ' ' << depth;
    }
  EXPECT_LT(largest_step(SceneDef{}, 0.012, 0.003, true), kNoStep);
}

TEST(FeltRimSteps, AWallThatBendsIsFeltWithoutAStepUpToTheRim) {
  SceneDef def;
  def.walls = WallsDef{.bending_strength = 14722.0};
  def.clay.wall_min = 0.002;
  for (const double wall : {0.004, 0.010}) {
    def.clay.inner_radius = def.clay.outer_radius - wall;
    EXPECT_LT(largest_step(def, 0.008, 0.003, false), kNoStep) << wall;
    EXPECT_LT(largest_step(def, 0.008, 0.003, true), kNoStep) << wall;
  }
}

}  // namespace
}  // namespace onggi::felt_rim_steps_test

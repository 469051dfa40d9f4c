// How a vessel is built of coils: where rings lie, and how hard a paddle strikes.
#include "engine/script/ring_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/portable.h"
#include "engine/scene/lump.h"
#include "engine/scene/scene.h"
#include "tests/engine/script/vessels.h"

namespace onggi::script::ring_plan_test {
namespace {

constexpr double kFloor = 0.010;
constexpr BeatingDef kSoft{0.15, 0.03, 16e3};  // as in config/scenes/built.toml
BuildingDef thick_coil() {
  BuildingDef law;
  law.coil = 0.018;
  law.drift = 0.0;
  return law;
}

Profile cylinder(double radius, double height) {
  Profile p;
  p.points = {{0.0, radius, 0.0}, {height, radius, radius - 0.005}};
  return p;
}

/// A pot of a floor and one straight wall.
ClayView pot(double outer, double wall, double height) {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 32;
  def.clay.height = height;
  def.clay.floor_thickness = kFloor;
  def.clay.outer_radius = outer;
  def.clay.inner_radius = outer - wall;
  ClayView view;
  const Result<Scene> made = Scene::create(def);
  EXPECT_TRUE(made) << to_text(made.error());
  if (made) view.take(made->clay());
  return view;
}
double ring_wall() {
  const BuildingDef law = thick_coil();
  return 0.25 * portable::kPi * law.coil * law.coil / effects::Building::ring_height(law, {});
}

TEST(RingPlan, LaysRingsInsideTheLineAsFarAsBlowsWillWidenThem) {
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const ClayView low = pot(0.07, 0.012, 0.05);
  const double laid = plan.next_ring(low);
  EXPECT_LT(laid, 0.08 - 0.5 * ring_wall() - 0.005);
  // ln(R' / R) = ln(t / t') / 2, by hand.
  const double wall = 0.55 * ring_wall();
  EXPECT_NEAR(laid * std::sqrt(ring_wall() / wall) + 0.5 * wall, 0.08, 1e-6);
  EXPECT_TRUE(plan.lacks_a_ring(low));
  BuildingDef drifts = thick_coil();
  drifts.drift = 0.1;
  const RingPlan holds_back(cylinder(0.08, 0.2), kFloor, drifts, kSoft);
  EXPECT_NEAR(holds_back.next_ring(low), laid - 0.1 * drifts.coil, 1e-9) << "coils lean out";
}

TEST(RingPlan, RingsThatWaitForBlowsTogetherHoldTheVesselsClay) {
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const double wall = 0.55 * ring_wall();
  const double wanted = portable::kPi * (0.08 * 0.08 - std::pow(0.08 - wall, 2)) * 0.19;
  const double inner = 0.060, outer = inner + ring_wall();
  const double height = wanted / (portable::kPi * (outer * outer - inner * inner));
  EXPECT_FALSE(plan.lacks_a_ring(pot(outer, ring_wall(), kFloor + height)));
  EXPECT_TRUE(plan.lacks_a_ring(pot(outer, ring_wall(), kFloor + 0.88 * height)));
  EXPECT_NEAR(plan.rings(), height / effects::Building::ring_height(thick_coil(), {}) + 1.0, 2.0);
}

TEST(RingPlan, WithoutAPaddleRingsFollowTheLineUpToItsHeight) {
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), std::nullopt);
  const ClayView low = pot(0.075, 0.015, 0.1);
  EXPECT_NEAR(plan.next_ring(low), 0.08 - 0.009, 1e-9);
  EXPECT_TRUE(plan.lacks_a_ring(low));
  EXPECT_FALSE(plan.lacks_a_ring(pot(0.075, 0.015, 0.195)));
  EXPECT_EQ(plan.swings(low, 0.05, 0.0), Swings{});
  EXPECT_FALSE(plan.to_beat(low));
  EXPECT_FALSE(plan.beaten(low));
  EXPECT_FALSE(plan.worst(low, std::nullopt));
}

// Rings lean inwards by 0.4 coils, a little more where the line bends: the belly below a narrow
// mouth cannot be laid wide.
TEST(RingPlan, BelowANarrowMouthNoRingIsLaidFartherOutThanTheNextOnesCanLeanBackFrom) {
  Profile jar = cylinder(0.08, 0.2);
  jar.points.insert(jar.points.begin() + 1, {0.16, 0.08, 0.075});
  jar.points.back().outer = 0.04;
  const RingPlan plan(jar, kFloor, thick_coil(), kSoft);
  const RingPlan straight(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const auto next = [](const RingPlan& of, double height) {
    return of.next_ring(pot(0.062 + 0.5 * ring_wall(), ring_wall(), height));
  };
  EXPECT_NEAR(next(plan, 0.02), next(straight, 0.02), 1e-6) << "far below it";
  double before = next(plan, 0.05);
  const double ring = effects::Building::ring_height(thick_coil(), {});
  for (double height = 0.05 + ring; height < 0.15; height += ring) {
    EXPECT_GT(next(plan, height), before - 0.7 * thick_coil().coil) << height;
    before = next(plan, height);
  }
  EXPECT_LT(before, 0.035) << "at the mouth";
}

TEST(RingPlan, AThickWallInsideTheLineIsSqueezedAndOneOnTheLineIsLeftAlone) {
  const double wall = 0.55 * ring_wall();
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const double inside = (0.08 - 0.5 * wall) * std::sqrt(wall / ring_wall()) + 0.5 * ring_wall();
  const ClayView thick = pot(inside, ring_wall(), 0.05);
  const Swings full = plan.swings(thick, 0.03, 0.4);
  EXPECT_GT(std::min(full.paddle, full.anvil), 0.5);
  EXPECT_NEAR(full.paddle, full.anvil, 0.05);
  const ClayView right = pot(0.08, wall, 0.2);
  const Swings none = plan.swings(right, 0.1, 0.4);
  EXPECT_LT(std::max(none.paddle, none.anvil), 0.05);
  EXPECT_FALSE(plan.to_beat(right));
  EXPECT_TRUE(plan.beaten(right));
}

TEST(RingPlan, TheHarderOneDrivesTheWallToTheLine) {
  const double wall = 0.55 * ring_wall();
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const Swings outwards = plan.swings(pot(0.074, wall, 0.2), 0.1, std::nullopt);
  EXPECT_GT(outwards.anvil, outwards.paddle + 0.02);
  const Swings inwards = plan.swings(pot(0.086, wall, 0.2), 0.1, std::nullopt);
  EXPECT_GT(inwards.paddle, inwards.anvil + 0.02);
  EXPECT_TRUE(plan.to_beat(pot(0.086, wall, 0.2)));
}

TEST(RingPlan, NoPotMakesSwingsOutsideTheirRange) {
  for (const auto& [name, drawn] : vessels::all()) {
    const Profile target = scaled(drawn, workspace_scale(drawn));
    const RingPlan plan(target, kFloor, thick_coil(), kSoft);
    for (const double outer : {0.02, 0.05, 0.11})
      for (const double wall : {0.006, 0.010})
        for (const double height : {0.03, 0.2})
          for (const double at : {-1.0, 0.0, 0.015, 0.1, 1.0}) {
            const Swings swings = plan.swings(pot(outer, wall, height), at, 12.0);
            EXPECT_GE(std::min(swings.paddle, swings.anvil), 0.0) << name;
            EXPECT_LE(std::max(swings.paddle, swings.anvil), 1.0) << name;
          }
  }
}

TEST(RingPlan, APotTooHighIsNeitherToBeBeatenNorGood) {
  const double wall = 0.55 * ring_wall();
  const RingPlan plan(cylinder(0.08, 0.2), kFloor, thick_coil(), kSoft);
  const ClayView high = pot(0.08, wall, 0.22);
  EXPECT_FALSE(plan.to_beat(high));
  EXPECT_FALSE(plan.beaten(high));
}

TEST(RingPlan, TheWorstPlaceStaysUntilAnotherIsMuchWorse) {
  Profile flared = cylinder(0.08, 0.2);
  flared.points.insert(flared.points.begin() + 1, {0.1, 0.08, 0.075});
  flared.points.back().outer = 0.095;
  const RingPlan plan(flared, kFloor, thick_coil(), kSoft);
  const ClayView straight = pot(0.08, 0.55 * ring_wall(), 0.2);
  const auto worst = plan.worst(straight, std::nullopt);
  ASSERT_TRUE(worst);
  EXPECT_GT(worst->height, 0.16) << "where the vessel is wider";
  EXPECT_FALSE(worst->inward);
  const auto beside = plan.worst(straight, worst->height - 0.03);
  ASSERT_TRUE(beside);
  EXPECT_LE(beside->height, worst->height);
  EXPECT_EQ(plan.worst(straight, 0.03)->height, worst->height);
}

}  // namespace
}  // namespace onggi::script::ring_plan_test

// How strong the joints of coils are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/effects/tearing.h"
#include "tests/engine/effects/building_hands.h"

namespace onggi::effects::joint_test {
namespace {

using namespace effects_test;

// Six rings, of which only the joints differ.
Scene built(double joint, double yield) {
  SceneDef def = bench(20);
  def.slump.emplace().yield_stress = yield;
  def.slump->viscosity = 100.0;
  def.building->joint = joint;
  def.building->wetness = 0.0;
  Scene scene = made(def);
  for (int k = 0; k < 6; ++k) {
    go_round(scene, 0.035);
    wait(scene, 0.2);
  }
  return scene;
}

TEST(Joint, AWallYieldsAtItsJointsFirst) {
  // 70 mm of clay press 1340 Pa on a ring as broad as the coil, and 1960 where it is squeezed.
  const auto stands = [](double joint, double yield) {
    Scene scene = built(joint, yield);
    wait(scene, 3.0);
    return scene.clay().rim_height();
  };
  const double firm = stands(1.0, 8000.0);
  EXPECT_NEAR(stands(1.0, 1500.0), firm, 1e-6);
  EXPECT_NEAR(stands(0.3, 8000.0), firm, 1e-6);
  EXPECT_LT(stands(0.3, 1500.0), firm - 1e-4);
}

// A disc with one ring of coil, all rows of which have come, and its lowest row.
struct Ringed {
  SceneDef def = bench(20);
  Clay clay = std::move(*Clay::create(def.clay));
  std::optional<Building> building;
  RowAdded lowest;

  Ringed() {
    def.clay.inner_radius = 0.04;  // of the lump's walls, which a disc has none of
    clay = std::move(*Clay::create(def.clay, best_vectors(), 100));
    clay.keep_areas();
    clay.keep_displacements();
    building.emplace(*def.building, clay);
    for (int i = 0; i < 64; ++i) {
      const double angle = (i + 0.5) / 64 * 2.0 * portable::kPi;
      const Vec3 at{0.035 * portable::cos(angle), 0.0164, 0.035 * portable::sin(angle)};
      EXPECT_TRUE(building->lay(*def.building, clay, at, at, 0.001, 0));
    }
    lowest = building->raise(*def.building, clay, 0);
  }
  double strength() const { return building->strength(*def.building, lowest.to); }
  // One face moves by `by` (m), all round.
  double work(WallSide side, float by) {
    Displacements& moved = *clay.displacements(side == WallSide::inside);
    std::fill_n(moved.row(lowest.to), 64, by);
    moved.mark(lowest.row, {0, 8});
    RowTick tick;
    building->run({def, clay, tick, nullptr, &*building, side, 0.001});
    moved.clear(clay.stored());
    return strength();
  }
};

TEST(Joint, AJointGetsAsStrongAsItWasWorkedMoreSoOnBothSides) {
  Ringed pot;
  EXPECT_EQ(pot.strength(), 0.3);
  // Of its 23 rows one has come, and none that the others will take may be divided away.
  EXPECT_EQ(pot.building->rows_kept(), 22);
  EXPECT_EQ(pot.building->strength(*pot.def.building, 0), 1.0) << "the floor has no joint";
  // Half a millimetre all round leaves 1/e of what was missing on that face.
  const double missing = 1.0 - std::exp(-1.0);
  EXPECT_NEAR(pot.work(WallSide::outside, 0.0005f), 0.3 + 0.5 * missing * 0.56, 1e-6);
  EXPECT_NEAR(pot.work(WallSide::inside, 0.0005f), 0.3 + missing * 0.56, 1e-6);
  for (int n = 0; n < 20; ++n)
    pot.work(WallSide::outside, 0.0005f), pot.work(WallSide::inside, 0.0005f);
  EXPECT_NEAR(pot.work(WallSide::outside, 0.0f), 0.86, 1e-6);
}

TEST(Joint, ABeatenJointGetsAsStrongAsTheWall) {
  Ringed pot;
  pot.building->beat(pot.lowest.to, 0.05);  // thinned by 5 %
  EXPECT_NEAR(pot.strength(), 1.0 - 0.7 * std::exp(-1.0), 1e-6);
  for (int n = 0; n < 20; ++n) pot.building->beat(pot.lowest.to, 0.01);
  EXPECT_GT(pot.strength(), 0.98);
  EXPECT_GT(pot.work(WallSide::outside, 0.0005f), 0.98) << "pinching takes nothing back";
  pot.building->beat(0, 0.1);
  EXPECT_EQ(pot.building->strength(*pot.def.building, 0), 1.0) << "the floor has no joint";
}

// A ring may get wider than it was laid by a tenth as laid, by a quarter when pinched.
TEST(Joint, APinchedJointHoldsWhereOneThatWasOnlyLaidTears) {
  const auto tears = [](bool pinched, float wider, double thickness) {
    Ringed pot;
    pot.def.walls.emplace().tear_strain = 0.3;
    pot.def.walls->tear_thickness = thickness;
    Tearing tearing(pot.clay);
    tearing.row_added(pot.clay, pot.lowest);
    for (int n = 0; pinched && n < 20; ++n)
      pot.work(WallSide::outside, 0.0005f), pot.work(WallSide::inside, 0.0005f);
    for (float& r : pot.clay.outer_mut(pot.lowest.row)) r *= wider;
    for (float& r : pot.clay.inner_mut(pot.lowest.row)) r *= wider;
    RowTick tick;
    tick.seconds = 0.2;
    tearing.run({pot.def, pot.clay, tick, nullptr, &*pot.building});
    return tearing.any();
  };
  EXPECT_FALSE(tears(false, 1.08f, 0.0));
  EXPECT_TRUE(tears(false, 1.15f, 0.0));
  EXPECT_FALSE(tears(true, 1.15f, 0.0));
  EXPECT_TRUE(tears(true, 1.3f, 0.0));
  // The squeezed foot of the ring is 8.5 mm thick, whatever its strength.
  EXPECT_FALSE(tears(false, 1.0f, 0.0035));
  EXPECT_TRUE(tears(true, 1.0f, 0.0095));
}

}  // namespace
}  // namespace onggi::effects::joint_test

#include "engine/effects/building.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/effects/tearing.h"
#include "engine/effects/volume.h"
#include "engine/scene/replay.h"
#include "tests/engine/effects/building_hands.h"
#include "tests/support/clay_shape.h"

namespace onggi::effects::building_test {
namespace {

using namespace effects_test;

int laid_sectors(const Scene& scene) {
  return static_cast<int>(
      std::ranges::count_if(scene.coil().centre, [](float c) { return c > 0; }));
}

float widest(const Clay& clay, int j) { return *std::ranges::max_element(clay.outer(j)); }

TEST(Building, ARingHoldsTheClayOfItsCoil) {
  for (const double coil : {0.008, 0.013, 0.03})
    for (const int rows : {8, 12, 100}) {
      SceneDef def = bench(rows);
      def.building->coil = coil;
      Scene scene = made(def);
      const double floor = scene.clay().volume();
      go_round(scene, 0.035);
      wait(scene, 0.5);
      EXPECT_NEAR((scene.clay().volume() - floor) / ring(def, 0.035), 1.0, 1e-7) << coil << rows;
      go_round(scene, 0.035);
      wait(scene, 0.5);
      EXPECT_NEAR((scene.clay().volume() - floor) / ring(def, 0.035), 2.0, 2e-7) << coil << rows;
      ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay()));
    }
}

// The radii are floats. Laid where a float is exact, the clay is right to a double's rounding.
TEST(Building, NoClayIsLostOrGainedByRounding) {
  SceneDef def = bench(12, 16);
  def.building->coil = 0.0078125 * 2;
  Scene scene = made(def);
  const double floor = scene.clay().volume();
  go_round(scene, 0.03125);
  wait(scene, 0.5);
  const double ring_laid = scene.clay().volume() - floor;
  EXPECT_NEAR(ring_laid / ring(def, 0.03125), 1.0, 1e-9);
}

TEST(Building, ARingOfDefaultCoilsIsAsHighAsItsSectionSqueezedALittle) {
  const SceneDef def = bench(20);
  Scene scene = made(def);
  go_round(scene, 0.035);
  wait(scene, 0.5);
  const double height = scene.clay().rim_height() - def.clay.height;
  EXPECT_GT(height, 0.85 * def.building->coil);
  EXPECT_LT(height, 0.95 * def.building->coil);
}

TEST(Building, HalfARingLiesWhereItWasLaidAndTheClayIsAsBefore) {
  const SceneDef def = bench();
  Scene scene = made(def);
  EXPECT_TRUE(scene.coil().centre.empty());
  const auto before = test::exact_shape(scene.clay());
  go_round(scene, 0.035, 0.5);
  EXPECT_EQ(test::exact_shape(scene.clay()), before);
  ASSERT_EQ(scene.coil().centre.size(), 64u);
  for (int i = 0; i < 64; ++i) {
    if (i <= 32)
      EXPECT_NEAR(scene.coil().centre[static_cast<std::size_t>(i)], 0.035, 1e-6) << i;
    else
      EXPECT_EQ(scene.coil().centre[static_cast<std::size_t>(i)], 0.0f) << i;
  }
  EXPECT_EQ(scene.coil().diameter, 0.013);
}

TEST(Building, WhoComesBackLaterGoesOnFromAnyEndOrBackwards) {
  const SceneDef def = bench();
  Scene scene = made(def);
  go_round(scene, 0.035, 0.4);
  wait(scene, 1.0);
  go_round(scene, 0.035, -0.35);
  EXPECT_GT(laid_sectors(scene), 44);
  wait(scene, 1.0);
  EXPECT_EQ(scene.clay().rows(), def.clay.rows);
  go_round(scene, 0.035, 0.5, 1.0, 0.001, 2.0);
  wait(scene, 0.5);
  EXPECT_GT(scene.clay().rows(), def.clay.rows);
  EXPECT_TRUE(scene.coil().centre.empty());
  EXPECT_NEAR(scene.coil().added / ring(def, 0.035), 1.0, 1e-6);
}

TEST(Building, AHandThatHoldsStillOverATurningWheelLaysTheSameRing) {
  const SceneDef def = bench();
  Scene by_hand = made(def), by_wheel = made(def);
  go_round(by_hand, 0.035, 1.0, 1.5);
  Hands hands;
  hands.wheel_speed = 5.0;
  hands.hand[0] = {{0.035, resting(by_wheel), 0.0}, true};
  hands.hand[0].coil = true;
  for (int n = 0; n < 1400; ++n) by_wheel.step(hands, 0.001);
  wait(by_hand, 0.1);
  ASSERT_EQ(by_hand.clay().rows(), by_wheel.clay().rows());
  for (int j = 0; j < by_hand.clay().rows(); ++j)
    for (std::size_t i = 0; i < 64; ++i)
      ASSERT_NEAR(by_hand.clay().outer(j)[i], by_wheel.clay().outer(j)[i], 1e-6) << j;
  EXPECT_NEAR(by_hand.clay().volume() / by_wheel.clay().volume(), 1.0, 1e-6);
}

TEST(Building, NeitherTheTickNorTheGridDecidesHowMuchClayARingBrings) {
  double most = 0.0, least = 1.0;
  for (const double tick : {0.00025, 0.001, 0.005})
    for (const int sectors : {16, 64, 360}) {
      const SceneDef def = bench(12, sectors);
      Scene scene = made(def);
      const double floor = scene.clay().volume();
      go_round(scene, 0.035, 1.0, 2.0, tick);
      wait(scene, 0.1);
      const double laid = (scene.clay().volume() - floor) / ring(def, 0.035);
      most = std::max(most, laid);
      least = std::min(least, laid);
    }
  // Between two ticks the hand goes straight on: at 5 ms the chord is 3e-5 shorter than the arc.
  EXPECT_NEAR(least, 1.0, 4e-5);
  EXPECT_NEAR(most, 1.0, 1e-6);
}

TEST(Building, ARimThatPassesTooFastTakesNoCoil) {
  SceneDef def = bench();
  def.building->pace = 0.1;
  Scene scene = made(def);
  go_round(scene, 0.035, 1.0, 2.0);  // 0.11 m/s
  EXPECT_LE(laid_sectors(scene), 1);
  EXPECT_EQ(scene.clay().rows(), def.clay.rows);
  go_round(scene, 0.035, 1.0, 2.4);  // 0.092 m/s
  wait(scene, 0.1);
  EXPECT_GT(scene.clay().rows(), def.clay.rows);
}

TEST(Building, ACoilHeldAboveTheRimOrBesideThePotIsNotLaid) {
  const SceneDef def = bench();
  Scene scene = made(def);
  Hands hands;
  hands.wheel_speed = 5.0;
  for (const Vec3 at : {Vec3{0.035, 0.0175, 0}, Vec3{0.06, 0.012, 0}, Vec3{0.0535, 0.002, 0}}) {
    hands.hand[0] = {at, true};
    hands.hand[0].coil = true;
    for (int n = 0; n < 1400; ++n) scene.step(hands, 0.001);
    EXPECT_EQ(laid_sectors(scene), 0) << at.x << ' ' << at.y;
  }
}

TEST(Building, StraightCoilsDriftOutwardsAndAHandThatLeansInHoldsThemBack) {
  SceneDef def = bench(20);
  def.building->drift = 0.1;
  Scene straight = made(def), held = made(def);
  for (int k = 0; k < 6; ++k) {
    const auto middle = [](const Clay& clay) {
      const int j = clay.rows() - 1;
      return 0.5 * (double{clay.outer(j)[0]} + double{clay.inner(j)[0]});
    };
    const bool first = k == 0;
    go_round(straight, first ? 0.035 : middle(straight.clay()));
    go_round(held, first ? 0.035 : middle(held.clay()) - 0.0013);
    wait(straight, 0.5);
    wait(held, 0.5);
  }
  const auto top = [](const Scene& s) { return widest(s.clay(), s.clay().rows() - 1); };
  EXPECT_GT(top(straight), widest(straight.clay(), def.clay.rows) + 0.006f);
  EXPECT_NEAR(top(held), widest(held.clay(), def.clay.rows), 0.001f);
}

TEST(Building, NoRingIsBegunThatWouldEndHigherThanAllowed) {
  SceneDef def = bench();
  def.building->tallest = 0.06;
  Scene scene = made(def);
  for (int k = 0; k < 9; ++k) {
    go_round(scene, 0.035);
    wait(scene, 0.1);
  }
  EXPECT_LE(scene.clay().rim_height(), 0.06);
  EXPECT_GT(scene.clay().rim_height(), 0.06 - 0.013);
  EXPECT_EQ(laid_sectors(scene), 0);
}

TEST(Building, ACoilThatIsThickerThanThePotMayBeWideIsNotLaid) {
  SceneDef def = bench();
  def.building->coil = 0.03;
  def.clay.outer_radius = 0.024;
  def.clay.inner_radius = 0.008;
  for (const double wide : {0.0258, 0.04}) {
    def.clay.radius_max = wide;
    Scene scene = made(def);
    go_round(scene, 0.012);
    wait(scene, 0.1);
    EXPECT_EQ(scene.clay().rows() > def.clay.rows, wide == 0.04);
    ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay()));
  }
}

TEST(Building, UndoTakesCoilsBackAsTheyWereLaid) {
  const SceneDef def = bench();
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  go_round(scene, 0.035);
  wait(scene, 1.0);
  const auto one = test::exact_shape(scene.clay());
  const double volume = scene.clay().volume();
  go_round(scene, 0.035, 0.5);
  wait(scene, 1.0);
  const int half = laid_sectors(scene);
  go_round(scene, 0.035, 0.5, 2.0, 0.001, portable::kPi);
  wait(scene, 1.0);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_GT(scene.clay().rows(), 2 * 12);
  undo(scene);
  EXPECT_EQ(laid_sectors(scene), half) << "the second half is taken back, the first one lies";
  EXPECT_EQ(test::exact_shape(scene.clay()), one);
  undo(scene);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_EQ(test::exact_shape(scene.clay()), one);
  EXPECT_NEAR(scene.clay().volume() / volume, 1.0, 1e-12);
  while (scene.can_restore()) undo(scene);
  const auto now = test::exact_shape(scene.clay());
  ASSERT_EQ(now.size(), floor.size());
  for (std::size_t n = 0; n < now.size(); ++n) ASSERT_NEAR(now[n], floor[n], 1e-15) << n;
  EXPECT_NEAR(scene.coil().added, 0.0, 1e-15);
  EXPECT_EQ(laid_sectors(scene), 0);
}

TEST(Building, AFreshLumpHasNoCoilsAndTakesNewOnes) {
  const SceneDef def = bench();
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  go_round(scene, 0.035, 2.5, 5.0);
  wait(scene, 0.1);
  Hands hands;
  hands.renew = true;
  wait(scene, 0.5, hands);
  EXPECT_EQ(test::exact_shape(scene.clay()), floor);
  EXPECT_EQ(laid_sectors(scene), 0);
  go_round(scene, 0.035);
  wait(scene, 0.1);
  EXPECT_GT(scene.clay().rows(), def.clay.rows);
}

TEST(Building, AFreshLumpThatIsTakenBackHasItsCoilsAgain) {
  SceneDef def = bench();
  def.clay.inner_radius = 0.02;
  def.walls.emplace().tear_strain = 0.3;
  Scene scene = made(def);
  go_round(scene, 0.041);
  wait(scene, 0.1);
  go_round(scene, 0.041, 0.6, 1.5);
  wait(scene, 1.0);
  const auto before = test::exact_shape(scene.clay());
  const double added = scene.coil().added;
  const int half = laid_sectors(scene);
  ASSERT_GT(half, 20);
  Hands hands;
  hands.renew = true;
  wait(scene, 0.5, hands);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_EQ(scene.coil().added, 0.0);
  undo(scene);
  EXPECT_EQ(test::exact_shape(scene.clay()), before);
  EXPECT_EQ(scene.coil().added, added);
  EXPECT_EQ(laid_sectors(scene), half);
  wait(scene, 0.5);
  EXPECT_FALSE(scene.step({}, 0.001).torn) << "a ring is as wide as it was laid";
}

// On a grid where a tick adds one row of ten, and a step that has lasted its longest.
TEST(Building, ARingThatRisesForSomeTicksIsTakenBackWhole) {
  SceneDef def = bench(8, 8192);
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  for (const double closes : {2.9935, 2.996, 2.9995}) {
    go_round(scene, 0.035, 1.0, closes);
    wait(scene, 1.0);
    EXPECT_NEAR(scene.coil().added / ring(def, 0.035), 1.0, 1e-4);
    undo(scene);
    EXPECT_EQ(scene.coil().added, 0.0) << closes;
    while (scene.can_restore()) undo(scene);
    EXPECT_EQ(scene.coil().added, 0.0);
    EXPECT_EQ(laid_sectors(scene), 0);
    ASSERT_EQ(test::exact_shape(scene.clay()).size(), floor.size());
    wait(scene, 0.5);
    ASSERT_EQ(test::exact_shape(scene.clay()).size(), floor.size()) << "nothing rises again";
  }
}

// The rows that a ring under way will take are not divided away.
TEST(Building, ARingUnderWayKeepsItsRows) {
  SceneDef def = bench();
  def.building->tallest = 0.05;
  Scene scene = made(def);
  for (int k = 0; k < 3; ++k) go_round(scene, 0.035), wait(scene, 0.1);
  RandomHands random(5);
  for (int round = 0; round < 8; ++round) {
    Hands hands;
    for (int n = 0; n < 600; ++n) {  // the rim is pressed down
      const double angle = 0.02 * n;
      hands.hand[0] = {{0.035 * portable::cos(angle), scene.clay().rim_height() + 0.005,
                        0.035 * portable::sin(angle)},
                       true};
      scene.step(hands, 0.001);
    }
    go_round(scene, 0.035, 0.7);
    for (int n = 0; n < 1500; ++n) {  // the wall is pinched
      const double angle = 0.01 * n;
      const auto at = [&](double out) {
        return Vec3{out * portable::cos(angle), 0.02, out * portable::sin(angle)};
      };
      hands.hand[0] = {at(0.047), true, SideWish::outside};
      hands.hand[1] = {at(0.023), true, SideWish::inside};
      scene.step(hands, 0.001);
    }
    go_round(scene, 0.035, 1.0, 2.0, 0.001, 3.0);
    wait(scene, 0.2);
    ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay())) << round;
    ASSERT_GE(scene.clay().spare_rows(), 0);
  }
}

TEST(Building, AHandAtTheAxisLaysNoRingAtOnce) {
  const SceneDef def = bench();
  Scene scene = made(def);
  Hands hands;
  for (int n = 0; n < 300; ++n) {
    hands.hand[0] = {{n % 2 == 0 ? 0.0002 : -0.0002, resting(scene) - 0.0005, 0.00001 * n}, true};
    hands.hand[0].coil = true;
    scene.step(hands, 0.001);
  }
  EXPECT_LE(laid_sectors(scene), 6);
  EXPECT_EQ(scene.clay().rows(), def.clay.rows);
}

TEST(Building, MoreRowsThanMemoryHoldsAreRefusedWithTheRemedy) {
  SceneDef def = bench(4096, 4096);
  def.building->tallest = 0.3;
  const auto refused = validate(def);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_text(refused.error()).find("building.tallest"), std::string::npos)
      << to_text(refused.error());
}

TEST(Building, AReplayLaysTheSameCoils) {
  SceneDef def = bench();
  def.slump.emplace();
  def.walls.emplace();
  Scene scene = made(def);
  ReplayWriter writer(def, "onggi", 7);
  Hands hands;
  for (int n = 0; n < 5200; ++n) {
    const double angle = 0.003 * n;
    hands.hand[0] = {{0.035 * portable::cos(angle), resting(scene), 0.035 * portable::sin(angle)},
                     true};
    hands.hand[0].coil = n < 4500;
    writer.tick({hands, 0.001});
    scene.step(hands, 0.001);
  }
  EXPECT_GT(scene.clay().rim_height(), 0.03);
  const auto bytes = writer.finish(scene.state_hash());
  const auto replay = Replay::read(bytes, "coils");
  ASSERT_TRUE(replay);
  const auto outcome = run_replay(*replay);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->replayed_hash, outcome->recorded_hash);
  EXPECT_TRUE(replay->ticks[10].hands.hand[0].coil);
  EXPECT_FALSE(replay->ticks[5000].hands.hand[0].coil);
}

TEST(Building, WithoutTheEffectAHandThatHoldsACoilWorksAsAnyOther) {
  SceneDef def;
  def.clay.rows = 40;
  def.clay.sectors = 64;
  Scene with = made(def), without = made(def);
  Hands hands;
  hands.wheel_speed = 10.0;
  hands.hand[0] = {{0.06, 0.1, 0.0}, true};
  for (int n = 0; n < 300; ++n) {
    hands.hand[0].coil = true;
    with.step(hands, 0.001);
    hands.hand[0].coil = false;
    without.step(hands, 0.001);
  }
  EXPECT_EQ(with.state_hash(), without.state_hash());
  EXPECT_LT(*std::ranges::min_element(with.clay().outer(20)), 0.0549f);
}

TEST(Building, ACoilBringsItsOwnWater) {
  SceneDef def = bench();
  def.moisture->sponge_height = 0.02;
  def.moisture->drying_time = 36000.0;
  def.building->wetness = 0.4;
  Scene scene = made(def);
  go_round(scene, 0.035);
  wait(scene, 0.1);
  EXPECT_NEAR(scene.wetness_of(scene.clay().rows() - 1), 0.4, 0.001);
  EXPECT_NEAR(scene.wetness_of(0), 0.0, 0.001);
}

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

TEST(Building, AWallYieldsAtItsJointsFirst) {
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

TEST(Building, AJointGetsAsStrongAsItWasWorkedMoreSoOnBothSides) {
  Ringed pot;
  EXPECT_EQ(pot.strength(), 0.3);
  EXPECT_EQ(pot.building->strength(*pot.def.building, 0), 1.0) << "the floor has no joint";
  // Half a millimetre all round leaves 1/e of what was missing on that face.
  const double missing = 1.0 - std::exp(-1.0);
  EXPECT_NEAR(pot.work(WallSide::outside, 0.0005f), 0.3 + 0.5 * missing * 0.56, 1e-6);
  EXPECT_NEAR(pot.work(WallSide::inside, 0.0005f), 0.3 + missing * 0.56, 1e-6);
  for (int n = 0; n < 20; ++n)
    pot.work(WallSide::outside, 0.0005f), pot.work(WallSide::inside, 0.0005f);
  EXPECT_NEAR(pot.work(WallSide::outside, 0.0f), 0.86, 1e-6);
}

// A ring may get wider than it was laid by a tenth as laid, by a quarter when pinched.
TEST(Building, APinchedJointHoldsWhereOneThatWasOnlyLaidTears) {
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

TEST(Building, AWallOfCoilsThatIsPinchedGetsHigherAsAThrownOneDoes) {
  const SceneDef def = bench(20);
  Scene scene = made(def);
  for (int k = 0; k < 4; ++k) {
    go_round(scene, 0.035);
    wait(scene, 0.1);
  }
  const double before = scene.clay().rim_height(), clay = scene.clay().volume();
  ASSERT_GT(before, Volume::kTallest * def.clay.height) << "higher than a lump may be thrown";
  Hands hands;
  const double finger = def.tool.radius;
  for (int n = 0; n < 4000; ++n) {
    const double angle = 0.0032 * n;
    const auto at = [&](double radius) {
      return Vec3{radius * portable::cos(angle), 0.03, radius * portable::sin(angle)};
    };
    hands.hand[0] = {at(0.0415 + finger - 0.002), true, SideWish::outside};
    hands.hand[1] = {at(0.0285 - finger + 0.002), true, SideWish::inside};
    scene.step(hands, 0.001);
  }
  EXPECT_GT(scene.clay().rim_height(), before + 0.0005);
  EXPECT_NEAR(scene.clay().volume() / clay, 1.0, 1e-7);
}

TEST(Building, RandomBuildersBreakNoLimit) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SceneDef def = bench(10, 48);
    def.walls.emplace();
    def.propagation.emplace();
    def.springback.emplace();
    def.smoothing.emplace();
    def.wobble.emplace();
    def.slump.emplace();
    def.building->tallest = 0.12;
    def.moisture->sponge_height = 0.04;
    Scene scene = made(def);
    const double lump = scene.clay().volume();
    RandomHands random(seed);
    int most = 0;
    for (int n = 0; n < 60000; ++n) {
      Hands hands = random.next();
      hands.wheel_speed *= 0.2;
      // Every third second a coil is held over the rim.
      if (n / 1000 % 3 != 0) {
        const double out = 0.035 + 0.003 * portable::sin(0.001 * n);
        hands.hand[0] = {{out, resting(scene) - 0.001, 0.0}, true};
        hands.hand[0].coil = true;
      }
      if (n % 9000 == 8999) hands.restore = true;
      if (n % 25000 == 24999) hands.renew = true;
      const Feedback back = scene.step(hands, random.seconds());
      ASSERT_LE(length(back.hand[0].force), def.guard.max_force * (1 + 1e-9)) << n;
      most = std::max(most, scene.clay().rows());
      if (n % 500 != 0 || scene.laying()) continue;
      ASSERT_NEAR(scene.clay().volume() / (lump + scene.coil().added), 1.0, 1e-7) << n;
      ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay())) << n;
      ASSERT_LE(scene.clay().rim_height(), 0.12 * 1.06) << n;
    }
    EXPECT_GT(most, 40) << "rings were closed";
  }
}

}  // namespace
}  // namespace onggi::effects::building_test

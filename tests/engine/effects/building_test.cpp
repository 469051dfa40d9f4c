#include "engine/effects/building.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/effects/volume.h"
#include "engine/scene/replay.h"
#include "tests/engine/effects/building_hands.h"
#include "tests/support/clay_shape.h"

namespace onggi::effects::building_test {
namespace {

using namespace effects_test;

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

// A visitor's ring stayed open for 90 s: the rim had a notch in which no coil rested.
TEST(Building, AGapNarrowerThanTheCoilClosesAndAWiderOneStaysOpen) {
  const SceneDef def = bench(12, 128);
  const double coil = def.building->coil, radius = 0.035;
  for (const double gap : {0.8, 1.5}) {
    Scene scene = made(def);
    const double floor = scene.clay().volume();
    go_round(scene, radius, 1.0 - gap * coil / (2.0 * portable::kPi * radius));
    wait(scene, 0.5);
    if (gap < 1.0) {
      EXPECT_EQ(laid_sectors(scene), 0);
      EXPECT_NEAR((scene.clay().volume() - floor) / ring(def, radius), 1.0, 1e-6) << "a whole ring";
    } else {
      EXPECT_GT(laid_sectors(scene), 64);
      EXPECT_LT(laid_sectors(scene), 128);
    }
  }
}

TEST(Building, AGapClosesBetweenItsEndsAndIsTakenBackWithThem) {
  SceneDef def = bench(12, 128);
  def.clay.keep_undo = true;
  Scene scene = made(def);
  const double coil = def.building->coil;
  go_round(scene, 0.030, 0.25);
  wait(scene, 1.0);
  // The next piece begins 0.7 coils farther on and 6 mm farther out.
  const double from = 2.0 * portable::kPi * (0.25 + 0.7 * coil / (2.0 * portable::kPi * 0.030));
  go_round(scene, 0.036, 0.1, 1.0, 0.001, from);
  const CoilView laid = scene.coil();
  const auto at = [&](double turn) {
    return double{laid.centre[static_cast<std::size_t>(turn * 128)]};
  };
  const double middle = 0.25 + 0.35 * coil / (2.0 * portable::kPi * 0.030);
  EXPECT_GT(at(middle), 0.0315);
  EXPECT_LT(at(middle), 0.0345);
  const int all = laid_sectors(scene);
  wait(scene, 0.5);
  undo(scene);
  EXPECT_NEAR(laid_sectors(scene), 32, 2) << "of " << all;
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

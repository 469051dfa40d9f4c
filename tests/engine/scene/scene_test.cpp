#include "engine/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/math/portable.h"
#include "engine/math/random.h"

namespace onggi::scene_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SceneDef small() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 90;
  return def;
}
Scene scene(const SceneDef& def = {}) { return std::move(*Scene::create(def)); }

Hands one_hand(Vec3 at, double wheel = 15.0) {
  Hands hands;
  hands.hand[0] = {at, true, SideWish::by_position};
  hands.wheel_speed = wheel;
  return hands;
}

Feedback run(Scene& s, const Hands& hands, int ticks) {
  Feedback out;
  for (int n = 0; n < ticks; ++n) out = s.step(hands, 0.001);
  return out;
}

// Moves hand 0 evenly to `to` over `ticks`.
Feedback move(Scene& s, Hands& hands, Vec3 to, int ticks) {
  const Vec3 from = hands.hand[0].position;
  Feedback out;
  for (int n = 1; n <= ticks; ++n) {
    hands.hand[0].position = from + (static_cast<double>(n) / ticks) * (to - from);
    out = s.step(hands, 0.001);
  }
  return out;
}

TEST(Scene, AToolPressedToATurningWallIsPushedOutAndDraggedAlong) {
  Scene s = scene();
  Hands hands = one_hand({0.07, 0.1, 0});
  run(s, hands, 1500);
  const Feedback out = move(s, hands, {0.0625, 0.1, 0}, 400);
  EXPECT_TRUE(out.hand[0].contact);
  EXPECT_EQ(out.hand[0].side, WallSide::outside);
  EXPECT_GT(out.hand[0].force.x, 0.0);
  EXPECT_GT(out.hand[0].force.z, 0.0);  // the wheel turns from x towards z
  EXPECT_GT(out.hand[0].depth, 0.0);
  EXPECT_EQ(out.faults, 0u);
  EXPECT_LT(s.clay().profile().outer_at(0.1), 0.055);
  EXPECT_EQ(s.clay().profile().outer_at(0.15), s.clay().profile().outer_at(0.02));
}

TEST(Scene, WithoutFrictionNothingDragsTheHand) {
  SceneDef def;
  def.friction.reset();
  Scene s = scene(def);
  Hands hands = one_hand({0.07, 0.1, 0}, 0.0);
  run(s, hands, 600);
  const Feedback out = move(s, hands, {0.0625, 0.1, 0}, 400);
  EXPECT_GT(out.hand[0].force.x, 0.0);
  EXPECT_NEAR(out.hand[0].force.z, 0.0, 1e-3 * out.hand[0].force.x);
}

TEST(Scene, TheWheelFollowsTheAskedSpeedAtItsOwnPaceAndKeepsWithinItsLimits) {
  Scene s = scene(small());
  Hands hands;
  hands.wheel_speed = 1000.0;
  EXPECT_NEAR(run(s, hands, 500).wheel_speed, 10.0, 1e-9);
  EXPECT_NEAR(run(s, hands, 2000).wheel_speed, 31.4, 1e-9);
  hands.wheel_speed = -5.0;
  const Feedback back = run(s, hands, 3000);
  EXPECT_NEAR(back.wheel_speed, -5.0, 1e-9);
  EXPECT_GE(back.wheel_angle, 0.0);
  EXPECT_LT(back.wheel_angle, 2.0 * portable::kPi);
}

TEST(Scene, WaterSoaksAndDriesAsExponentialsAtAnyTickLength) {
  constexpr double kDries = 0.6 / 60.0;  // while it soaks
  const double wet = (1.0 - std::exp(-1.0 - kDries)) / (1.0 + kDries);
  for (double dt : {0.0005, 0.005}) {
    Scene s = scene(small());
    Hands hands;
    hands.water = true;
    for (int n = 0; n < static_cast<int>(0.6 / dt + 0.5); ++n) s.step(hands, dt);
    EXPECT_NEAR(s.step(hands, 1e-5).wetness, wet, 1e-4);
    hands.water = false;
    Feedback out;
    for (int n = 0; n < static_cast<int>(6.0 / dt + 0.5); ++n) out = s.step(hands, dt);
    EXPECT_NEAR(out.wetness, wet * std::exp(-0.1), 1e-4);
  }
}

TEST(Scene, WetClayGivesWaySoonerAndDragsLess) {
  double radius[2], drag[2];
  for (int wet : {0, 1}) {
    Scene s = scene();
    Hands hands = one_hand({0.07, 0.1, 0});
    hands.water = wet == 1;
    run(s, hands, 3000);
    const Feedback out = move(s, hands, {0.0620, 0.1, 0}, 100);
    radius[wet] = s.clay().profile().outer_at(0.1);
    drag[wet] = out.hand[0].force.z / out.hand[0].force.x;
  }
  EXPECT_LT(radius[1], radius[0]);
  EXPECT_LT(drag[1], 0.6 * drag[0]);
}

TEST(Scene, WithoutWaterTheSpongeDoesNothing) {
  SceneDef def = small();
  def.moisture.reset();
  Scene s = scene(def);
  Hands hands;
  hands.water = true;
  EXPECT_EQ(run(s, hands, 100).wetness, 0.0);
}

TEST(Scene, TheFloorAndTheWheelHeadPushUp) {
  Scene s = scene();
  Hands inside = one_hand({0.005, 0.05, 0}, 0.0);
  run(s, inside, 700);
  EXPECT_GT(move(s, inside, {0.005, 0.015, 0}, 400).hand[0].force.y, 0.2);  // 3 mm into the floor
  Scene t = scene();
  Hands beside = one_hand({0.12, 0.05, 0}, 0.0);
  run(t, beside, 700);
  EXPECT_EQ(move(t, beside, {0.12, 0.009, 0}, 400).hand[0].force.y, 0.0);
  EXPECT_GT(move(t, beside, {0.12, 0.005, 0}, 400).hand[0].force.y, 0.2);
}

TEST(Scene, ASampleThatIsNoneIsHeldCountedAndFeltAsNothing) {
  Scene s = scene();
  Hands hands = one_hand({0.07, 0.1, 0});
  run(s, hands, 1500);
  move(s, hands, {0.0625, 0.1, 0}, 400);
  const Vec3 good = hands.hand[0].position;
  for (Vec3 bad :
       {Vec3{kNan, 0, 0}, Vec3{0, std::numeric_limits<double>::infinity(), 0}, Vec3{0, 0, 11.0}}) {
    s.clear_faults();
    const std::uint64_t held = s.counters().held_samples;
    hands.hand[0].position = bad;
    const Feedback out = run(s, hands, 20);
    EXPECT_EQ(out.faults, std::uint32_t{kFaultInput});
    EXPECT_EQ(s.counters().held_samples, held + 20);
    EXPECT_EQ(length(out.hand[0].force), 0.0);
    hands.hand[0].position = good;
    EXPECT_LT(length(run(s, hands, 1).hand[0].force), 0.05);  // engages again, slowly
    run(s, hands, 700);
  }
  s.clear_faults();
  EXPECT_EQ(run(s, hands, 1).faults, 0u);
}

TEST(Scene, ATickThatIsTooLongOrNoneIsClampedAndCounted) {
  Scene s = scene(small());
  for (double dt : {0.0, -1.0, kNan, 0.006, 1e9}) s.step({}, dt);
  EXPECT_EQ(s.counters().clamped_times, 5u);
  EXPECT_LE(s.time(), 0.010004);
  EXPECT_EQ(s.step({}, 0.005).faults, std::uint32_t{kFaultTime});
}

TEST(Scene, AHandThatIsPutDownElsewhereDoesNotCutAWayThere) {
  Scene s = scene();
  Hands hands = one_hand({0.08, 0.1, 0}, 0.0);
  run(s, hands, 10);
  hands.hand[0].position = {-0.08, 0.1, 0};  // the other side of the pot, a tick later
  run(s, hands, 10);
  EXPECT_NEAR(s.clay().profile().outer_at(0.1), 0.055, 1e-9);
}

TEST(Scene, RenewLaysAFreshLumpOverSomeTicksAndRestoreTakesItBack) {
  Scene s = scene();
  Hands hands = one_hand({0.07, 0.1, 0});
  run(s, hands, 500);
  move(s, hands, {0.058, 0.1, 0}, 500);
  hands.hand[0].active = false;
  run(s, hands, 10);
  const Profile shaped = s.clay().profile();
  hands.renew = true;
  run(s, hands, 1);
  EXPECT_NE(s.clay().profile().outer_at(0.1), 0.055f);  // not all in one tick
  run(s, hands, 20);                                    // held down: no second lump
  hands.renew = false;
  run(s, hands, 5);
  EXPECT_EQ(s.clay().profile().outer_at(0.1), double{0.055f});
  hands.restore = true;
  run(s, hands, 30);
  EXPECT_EQ(s.clay().profile().outer_at(0.1), shaped.outer_at(0.1));
  EXPECT_EQ(s.counters().clamped_times, 0u);
}

TEST(Scene, CostFollowsTheElementsVisited) {
  const auto visited = [](const SceneDef& def, Vec3 at) {
    Scene s = scene(def);
    run(s, one_hand(at, 0.0), 10);
    return s.counters().visited_elements;
  };
  SceneDef tall;
  tall.clay.height = 0.4;
  tall.clay.rows = 800;  // twice the elements, the same spacing
  EXPECT_EQ(visited(tall, {0.0625, 0.1, 0}), visited({}, {0.0625, 0.1, 0}));
  EXPECT_EQ(visited({}, {0.0625, 0.4, 0}), 0u);  // above the pot
  Hands lifted = one_hand({0.0625, 0.1, 0});
  lifted.hand[0].active = false;
  Scene s = scene();
  run(s, lifted, 10);
  EXPECT_EQ(s.counters().visited_elements, 0u);
}

TEST(Scene, OnlyTouchedRowsAreDirty) {
  Scene s = scene();
  while (s.take_dirty_row(0) >= 0) {
  }
  run(s, one_hand({0.0625, 0.1, 0}), 200);
  int rows = 0;
  for (int j = s.take_dirty_row(0); j >= 0; j = s.take_dirty_row(j + 1)) {
    EXPECT_NEAR(s.clay().row_height(j), 0.1, 0.008);
    ++rows;
  }
  EXPECT_GT(rows, 2);
}

TEST(Scene, AHundredThousandRandomTicksStayFiniteAndWithinEveryLimit) {
  SceneDef def = small();
  def.wheel.max_speed = 62.9;
  def.wheel.acceleration = 1000.0;
  Scene s = scene(def);
  Random random(99);
  Hands hands;
  for (int n = 0; n < 100000; ++n) {
    for (HandInput& hand : hands.hand) {
      if (random.uniform() < 0.01) hand.active = !hand.active;
      if (random.uniform() < 0.01) hand.side = static_cast<SideWish>(random.bits() % 3);
      if (random.uniform() < 0.002)
        hand.position = {random.uniform(-0.2, 0.2), random.uniform(-0.05, 0.25), 0};
      const double step = random.uniform() < 0.05 ? 0.03 : 0.001;
      hand.position += Vec3{random.uniform(-step, step), random.uniform(-step, step),
                            random.uniform(-step, step)};
      if (length(hand.position) > 0.3) hand.position = {};
      if (random.uniform() < 0.001) hand.position.x = kNan;
      if (!is_finite(hand.position) && random.uniform() < 0.2) hand.position = {};
    }
    if (random.uniform() < 0.005) hands.wheel_speed = random.uniform(-63, 63);
    if (random.uniform() < 0.0005) hands.renew = !hands.renew;
    if (random.uniform() < 0.0005) hands.restore = !hands.restore;
    hands.water = random.uniform() < 0.3;
    const double dt = std::ldexp(0.005, -static_cast<int>(random.bits() % 12));
    const Feedback out = s.step(hands, dt);
    for (const HandFeedback& felt : out.hand) {
      ASSERT_TRUE(is_finite(felt.force));
      ASSERT_LE(length(felt.force), def.guard.max_force * (1.0 + 1e-12));
      ASSERT_GE(felt.depth, 0.0);
      ASSERT_LT(felt.depth, 0.32);
    }
    ASSERT_EQ(out.faults & kFaultForce, 0u);
  }
  const float rounding = 3e-8f;
  for (int j = 0; j < s.clay().rows(); ++j) {
    for (std::size_t i = 0; i < 90; ++i) {
      const float out = s.clay().outer(j)[i];
      const float in = s.clay().inner(j)[i];
      ASSERT_GE(in, j < s.clay().floor_rows() ? 0.0f : 0.002f - rounding);
      ASSERT_GE(out, in + 0.004f - rounding);
      ASSERT_LE(out, 0.16f + rounding);
    }
  }
}

}  // namespace
}  // namespace onggi::scene_test

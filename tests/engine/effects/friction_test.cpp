#include "engine/effects/friction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::friction_test {
namespace {

TEST(Friction, IsSilentWithoutSlipAndSettlesAtMuTimesN) {
  const Vec3 reaction{2, 0, 0};
  EXPECT_EQ(friction_force(reaction, 2.0, {0, 0, 0}, 0.35, 0.01), (Vec3{0, 0, 0}));
  const Vec3 fast = friction_force(reaction, 2.0, {0, 0, 5.0}, 0.35, 0.01);
  EXPECT_NEAR(fast.z, -0.7, 1e-5);
  const Vec3 half = friction_force(reaction, 2.0, {0, 0, 0.01}, 0.35, 0.01);
  EXPECT_NEAR(half.z, -0.7 / std::sqrt(2.0), 1e-12);  // smooth through rest
}

TEST(Friction, ATurningWheelDragsARestingHandAlong) {
  const Vec3 touch{0.055, 0.1, 0};
  const Vec3 slip = Vec3{} - clay_velocity(touch, 20.0);  // hand at rest
  EXPECT_NEAR(slip.z, -1.1, 1e-12);
  EXPECT_GT(friction_force({1, 0, 0}, 1.0, slip, 0.35, 0.01).z, 0.0);  // from x towards z
}

RC_GTEST_PROP(FrictionProperty, NeverExceedsMuNAndNeverPushesAlongTheSlip, ()) {
  const auto some = [] { return *rc::gen::inRange(-1000, 1001) * 0.003; };
  const Vec3 reaction{some(), some(), some()};
  const Vec3 slip{some(), some(), some()};
  const double normal = *rc::gen::inRange(0, 1000) * 0.01;
  const Vec3 f = friction_force(reaction, normal, slip, 0.35, 0.01);
  RC_ASSERT(length(f) <= 0.35 * normal + 1e-12);
  RC_ASSERT(dot(f, slip) <= 1e-9);
  RC_ASSERT(std::fabs(dot(f, reaction)) <= 1e-9 * (1.0 + length(reaction) * normal));
}

TEST(Friction, WetClayDragsLessByTheWetFactor) {
  const FrictionDef def;
  EXPECT_EQ(friction_coefficient(def, 0.0), def.coefficient);
  EXPECT_DOUBLE_EQ(friction_coefficient(def, 1.0), def.coefficient * def.wet_factor);
}

// Along a wheel at rest, and off it by a hand that holds still: what friction there is, as a share
// of the most there could be.
double felt_at_rest(double tremble) {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 96;
  def.contact.relaxation_time = 1.0;  // so that there is something to press on
  def.guard.engage_time = 0.05;
  def.moisture.reset();
  Scene scene = effects_test::made(def);
  Random random(11);
  double most = 0.0;
  for (int n = 0; n < 600; ++n) {
    Hands hands;
    const auto off = [&] { return random.uniform() < 0.5 ? -0.5 * tremble : 0.5 * tremble; };
    const double in = 0.002 * std::min(n / 200.0, 1.0);
    hands.hand[0] = {{0.0635 - in, 0.1 + off(), off()}, true, SideWish::outside};
    const HandFeedback felt = scene.step(hands, 0.001).hand[0];
    if (n < 400) continue;
    EXPECT_GT(felt.force.x, 0.1) << n;
    most = std::max(
        most, std::hypot(felt.force.y, felt.force.z) / (def.friction->coefficient * felt.force.x));
  }
  return most;
}

TEST(Friction, OfAStillHandIsNothingThoughItTremblesByHalfACountOfItsEncoder) {
  EXPECT_LT(felt_at_rest(5.5e-5), 0.05);
}

}  // namespace
}  // namespace onggi::effects::friction_test

#include "engine/effects/friction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace onggi::effects {
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

}  // namespace
}  // namespace onggi::effects

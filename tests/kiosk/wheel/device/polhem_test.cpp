#include "kiosk/wheel/device/codecs/polhem.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kiosk/wheel/device/arm_kinematics.h"

namespace onggi::device::polhem::polhem_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Polhem, EncodersAreTheFirstFourteenOfSixtyFourBytes) {
  Bytes report(64, 0xee);
  for (std::size_t n = 0; n < 7; ++n)
    put_i16(report, 2 * n, static_cast<std::int16_t>(n * 1000 - 3000));
  Input input;
  ASSERT_EQ(read(report, input), ReportResult::news);
  EXPECT_EQ(input.encoder, (std::array<std::int16_t, 6>{-3000, -2000, -1000, 0, 1000, 2000}));
  EXPECT_EQ(input.info, 3000);
  report.pop_back();
  Input other;
  EXPECT_EQ(read(report, other), ReportResult::broken);
  EXPECT_EQ(other, Input{});
}

TEST(Polhem, CurrentsFollowAnEmptyIdAndNoneIsBeyondTheClamp) {
  const auto bytes = currents({100.4, -250.0, 7.6}, 2000);
  ASSERT_EQ(bytes.size(), 65u);
  EXPECT_EQ(bytes[0], 0);
  EXPECT_EQ(i16_at(bytes, 1), 100);
  EXPECT_EQ(i16_at(bytes, 3), -250);
  EXPECT_EQ(i16_at(bytes, 5), 8);
  EXPECT_EQ(i16_at(bytes, 7), 0);
  // Beyond the clamp all three go down together, so that the force keeps its direction.
  const auto held = currents({4000, -2000, 1000}, 2000);
  EXPECT_EQ(i16_at(held, 1), 2000);
  EXPECT_EQ(i16_at(held, 3), -1000);
  EXPECT_EQ(i16_at(held, 5), 500);
  EXPECT_TRUE(rc::check([] {
    const double most = *rc::gen::inRange(0, 40000);
    std::array<double, 3> wanted{};
    for (double& value : wanted) value = 1e-3 * *rc::gen::inRange(-2000000000, 2000000000);
    const auto sent = currents(wanted, most);
    for (std::size_t n = 0; n < 3; ++n)
      RC_ASSERT(std::abs(i16_at(sent, 1 + 2 * n)) <= std::min(most, 32767.0));
  }));
}

TEST(Polhem, ACurrentThatIsNoNumberStopsAllThreeMotors) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, std::numeric_limits<double>::infinity()})
    for (const std::array<double, 3>& wanted :
         {std::array{bad, 1000.0, 1000.0}, {1000.0, bad, 1000.0}, {1000.0, 1000.0, bad}})
      EXPECT_EQ(currents(wanted, 2000), currents({0, 0, 0}, 2000));
  EXPECT_EQ(currents({1, 2, 3}, nan), currents({0, 0, 0}, 2000));
}

TEST(Polhem, CalibratingSaysWhereTheArmStandsAndPushesNothing) {
  const auto bytes = calibrate({0, -5, 6000});
  EXPECT_EQ(i16_at(bytes, 1), 0);
  EXPECT_EQ(i16_at(bytes, 7), 1);
  EXPECT_EQ(i16_at(bytes, 9), 0);
  EXPECT_EQ(i16_at(bytes, 11), -5);
  EXPECT_EQ(i16_at(bytes, 13), 6000);
}

}  // namespace
}  // namespace onggi::device::polhem::polhem_test

namespace onggi::device {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(ArmKinematics, AnArmThatStandsAsItsFigureIsWhereTheFigureSays) {
  ArmDef arm;
  arm.origin = {};
  // Link b upright and link c level, straight out to the visitor.
  const Vec3 at = arm_position(arm, {0, 0, kPi / 2});
  EXPECT_NEAR(at.x, 0.245, 1e-12);
  EXPECT_NEAR(at.y, 0.0, 1e-12);
  EXPECT_NEAR(at.z, 0.080 + 0.205, 1e-12);
  // A quarter round the turntable.
  const Vec3 round = arm_position(arm, {kPi / 2, 0, kPi / 2});
  EXPECT_NEAR(round.x, 0.0, 1e-12);
  EXPECT_NEAR(round.y, 0.245, 1e-12);
}

TEST(ArmKinematics, AMotorTurnsItsBodyByTheCapstan) {
  ArmDef arm;
  EXPECT_NEAR(arm_angles(arm, {2000, 0, 0})[0], 2 * kPi / 16, 1e-12);
  arm.aligned = {true, true, true};
  EXPECT_NEAR(arm_angles(arm, {0, 2000, 0})[1], -2 * kPi / 12, 1e-12);
}

// Virtual work: what the motors do when they turn a little is what the handle's force does on its
// way. It holds the currents to the positions, whatever the arm.
TEST(ArmKinematics, MotorsAndHandleDoTheSameWork) {
  EXPECT_TRUE(rc::check([] {
    ArmDef arm;
    for (std::size_t n = 0; n < 3; ++n) {
      arm.aligned[n] = *rc::gen::arbitrary<bool>();
      arm.capstan[n] = 0.005 + 1e-5 * *rc::gen::inRange(0, 2000);
      arm.torque[n] = 0.01 + 1e-4 * *rc::gen::inRange(0, 3000);
    }
    ArmAngles at{};
    for (double& angle : at) angle = 1e-3 * *rc::gen::inRange(-1500, 1500);
    const Vec3 force{1e-2 * *rc::gen::inRange(-500, 500), 1e-2 * *rc::gen::inRange(-500, 500),
                     1e-2 * *rc::gen::inRange(-500, 500)};
    const auto currents = arm_currents(arm, at, force);
    for (std::size_t n = 0; n < 3; ++n) {
      constexpr double kStep = 1e-6;
      ArmAngles to = at, from = at;
      to[n] += kStep;
      from[n] -= kStep;
      const double handle = dot(force, arm_position(arm, to) - arm_position(arm, from));
      const double sense = arm.aligned[n] ? -1.0 : 1.0;
      const double motor_turn = sense * 2 * kStep * arm.body[n] / arm.capstan[n];
      const double motor = 1e-3 * currents[n] * arm.torque[n] * motor_turn;
      RC_ASSERT(std::fabs(handle - motor) < 1e-12);
    }
  }));
}

}  // namespace
}  // namespace onggi::device

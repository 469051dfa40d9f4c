#include "kiosk/device/hid_hand.h"

#include <algorithm>

#include "tests/kiosk/device/rig.h"
#include "tests/stand_in/simulated_others.h"
#include "tests/stand_in/simulated_puck.h"

namespace onggi::device {
namespace {

using stand_in::SimulatedArm;
using stand_in::SimulatedController;
using stand_in::SimulatedHandle;
using stand_in::SimulatedPuck;

/// Down the wall and up again, at a potter's pace.
stand_in::Track stroke(Vec3 from, long ms, long start) {
  std::vector<stand_in::TrackPoint> points;
  for (long n = 0; n < ms; ++n) {
    const double way = static_cast<double>(n) / static_cast<double>(ms);
    points.push_back({from + Vec3{-0.01 * way, 0.05 * std::sin(6.28 * way), 0.0}, true});
  }
  return stand_in::Track(points, start);
}

TEST(HidHand, APuckLeadsTheToolAlongAStrokeWithinAMillimetre) {
  for (const auto reports : {SimulatedPuck::Reports::split, SimulatedPuck::Reports::combined}) {
    const auto track = stroke({0.065, 0.10, 0.02}, 6000, 2500);
    Rig rig(std::make_unique<SimulatedPuck>(reports, track));
    ASSERT_TRUE(rig.open());
    double worst = 0.0;
    for (long ms = 1; ms < 8500; ++ms) {
      const HandInput in = rig.tick();
      if (ms < 2520) continue;
      EXPECT_TRUE(in.active) << ms;
      worst = std::max(worst, length(in.position - track.at(ms).at));
    }
    EXPECT_LT(worst, 1e-3);
  }
}

TEST(HidHand, APuckThatIsLetGoOfLiftsTheToolAndLaterBeginsAtHome) {
  Rig untouched(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split, stand_in::Track()));
  ASSERT_TRUE(untouched.open());
  EXPECT_FALSE(untouched.tick(50).active) << "nobody has touched it yet";
  Rig rig(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split,
                                          stroke({0.065, 0.10, 0.02}, 500, 2500)));
  ASSERT_TRUE(rig.open());
  EXPECT_TRUE(rig.tick(2700).active);
  const HandInput left = rig.tick(2000);
  EXPECT_FALSE(left.active);
  EXPECT_LT(length(left.position - Vec3{0.06, 0.10, 0.02}), 0.04);
  EXPECT_EQ(rig.tick(4000).position, default_def(DeviceKind::space_mouse).home);
  Rig left_handed(
      std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split, stand_in::Track()));
  ASSERT_TRUE(left_handed.open());
  EXPECT_LT(HidHand(left_handed.link, true).read(1e-3).position.x, 0.0);
}

TEST(HidHand, APuckThatFallsSilentWhilePushedDoesNotDriftOn) {
  Rig rig(std::make_unique<SimulatedPuck>(SimulatedPuck::Reports::split,
                                          stroke({0.065, 0.05, 0.02}, 6000, 2500)),
          {{3000, 3000, stand_in::Fault::stall}});
  ASSERT_TRUE(rig.open());
  rig.tick(3000);
  const Vec3 then = rig.tick(200).position;
  EXPECT_LT(length(rig.tick(500).position - then), 1e-6);
}

TEST(HidHand, AStickMovesTheToolAndThePushOfTheClayMakesItTremble) {
  for (const bool bluetooth : {false, true}) {
    auto owned = std::make_unique<SimulatedController>(bluetooth, 255, 128);
    SimulatedController& controller = *owned;
    Rig rig(std::move(owned));
    ASSERT_TRUE(rig.open());
    const Vec3 home = rig.link->def().home;
    EXPECT_NEAR(rig.tick(501, {}, false).position.x, home.x + 0.5 * rig.link->def().speed, 2e-3);
    EXPECT_EQ(controller.slow(), 0);
    rig.tick(20, {1.5, 0, 0});
    EXPECT_NEAR(controller.slow(), 100, 2) << bluetooth;
    EXPECT_GT(controller.quick(), 0) << "the first touch is a tap";
    rig.tick(100, {3.0, 0, 0});
    EXPECT_NEAR(controller.slow(), 200, 2);
    EXPECT_EQ(controller.quick(), 0);
    rig.tick(20, {}, false);
    EXPECT_EQ(controller.slow(), 0);
    rig.tick(40, {3.0, 0, 0});
    rig.feels = false;
    rig.tick(40);
    EXPECT_EQ(controller.slow(), 0) << "the loop stands still, and so does it";
    rig.feels = true;
    rig.tick(40, {3.0, 0, 0});
    EXPECT_GT(controller.slow(), 0);
    rig.hand.reset();
    rig.link.reset();
    EXPECT_EQ(controller.slow(), 0) << "the program has ended";
  }
}

TEST(HidHand, TheArmStandsWhereItsHandleIsAndItsMotorsPullAsTheClayPushes) {
  auto owned = std::make_unique<SimulatedArm>(stroke({0.065, 0.10, 0.02}, 5000, 0));
  SimulatedArm& arm = *owned;
  Rig rig(std::move(owned));
  DeviceDef def = default_def(DeviceKind::polhem);
  def.stiffness_limit = 800.0;
  ASSERT_TRUE(rig.open(&def));
  const auto track = stroke({0.065, 0.10, 0.02}, 5000, 0);
  HandInput in = rig.tick(300);
  EXPECT_TRUE(in.active) << "moved by somebody";
  // 2000 counts a turn on these capstans are some 0.05 mm at the handle.
  EXPECT_LT(length(in.position - track.at(rig.socket->ms - 1).at), 3e-4);
  rig.tick(700, {2.0, 0.0, 0.0});
  const auto& mA = arm.milliamperes();
  EXPECT_GT(std::abs(mA[0]) + std::abs(mA[1]) + std::abs(mA[2]), 100);
  EXPECT_EQ(rig.link->status().force, Vec3({0.0, 2.0, 0.0})) << "studio x is the arm's y";
  rig.feels = false;
  rig.tick(15);
  EXPECT_EQ(arm.milliamperes(), (std::array<int, 3>{}));
}

TEST(HidHand, AHandlesPlaceIsTheToolsAndTheClutchLetsItReachFurther) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  Rig rig(std::make_unique<SimulatedHandle>(still(home + Vec3{0.01, 0.02, 0.03}, 10000)));
  DeviceDef def = default_def(DeviceKind::onggi_hid);
  def.scale = 2.0;
  ASSERT_TRUE(rig.open(&def));
  const HandInput in = rig.tick(500);
  EXPECT_TRUE(in.active);
  EXPECT_LT(length(in.position - (home + Vec3{0.02, 0.04, 0.06})), 1e-5);
}

TEST(HidHand, NobodyAtTheHandleIsNoHandAtTheClay) {
  const Vec3 home = default_def(DeviceKind::onggi_hid).home;
  Rig rig(std::make_unique<SimulatedHandle>(still(home, 1000)));
  ASSERT_TRUE(rig.open());
  EXPECT_TRUE(rig.tick(500).active);
  EXPECT_FALSE(rig.tick(600).active) << "let go";
  EXPECT_EQ(rig.link->status().force, Vec3{});
}

}  // namespace
}  // namespace onggi::device

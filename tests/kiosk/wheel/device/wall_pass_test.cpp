#include "kiosk/wheel/device/wall_pass.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::device::wall_pass_test {
namespace {

constexpr double kWall = 0.055, kThin = 0.004, kFrame = 1.0 / 60;

ClayView lump(double height = 0.2) {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  def.height = height;
  def.inner_radius = kWall - kThin;
  ClayView clay;
  clay.lay(def);
  return clay;
}

WallHold both_hands(const ClayView& clay) {
  WallHold hold({2, 0.018}, {0, 0.008});
  hold.take(clay, Grip::both, 0.1);
  return hold;
}

/// A pass from `from` to `to`, m, at 50 mm/s.
void go(WallPass& pass, const ClayView& clay, double from, double to, double wanted = kWall) {
  const WallHold hold = both_hands(clay);
  const int frames = static_cast<int>(std::ceil(std::abs(to - from) / (0.05 * kFrame)));
  for (int n = 1; n <= frames; ++n)
    pass.go(hold, clay, from + (to - from) * n / frames, wanted, kFrame);
}

RC_GTEST_PROP(WallPass, AWallIsMovedToWhereItIsWantedButNoFurtherThanAPassGoes, ()) {
  const ClayView clay = lump();
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  WallPass pass;
  const double from = metres(20, 180), wanted = metres(0, 120);
  pass.begin(both_hands(clay), clay, from);
  go(pass, clay, from, metres(20, 180));
  const double reach = pass.within(wanted);
  RC_ASSERT(std::abs(reach - kWall) <= WallPass::kDeepest + 1e-6);
  if (std::abs(wanted - kWall) <= WallPass::kDeepest)
    RC_ASSERT(std::abs(reach - wanted) < 1e-9);
  else
    RC_ASSERT((wanted - kWall) * (reach - kWall) > 0);
}

TEST(WallPass, HandsThatComeBackOverWhatTheyWorkedEvenIt) {
  const ClayView clay = lump();
  WallPass pass;
  pass.begin(both_hands(clay), clay, 0.06);
  go(pass, clay, 0.06, 0.12);
  EXPECT_EQ(pass.backs(), 0);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest, 1e-6);
  go(pass, clay, 0.12, 0.10);
  EXPECT_EQ(pass.backs(), 1);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kEvening, 1e-6);
  EXPECT_NEAR(pass.within(0.0), kWall - WallPass::kEvening, 1e-6);
  go(pass, clay, 0.10, 0.14);
  EXPECT_EQ(pass.backs(), 2);
  pass.begin(both_hands(clay), clay, 0.06);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest, 1e-6) << "taken hold of anew";
}

// A lump is opened in large steps, and what is thin already is worked gently.
TEST(WallPass, AThickWallIsMovedByAShareOfItsThickness) {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  ClayView clay;
  const auto most = [&](double thick) {
    def.inner_radius = kWall - thick;
    clay.lay(def);
    WallPass pass;
    pass.begin(both_hands(clay), clay, 0.06);
    go(pass, clay, 0.06, 0.12);
    return pass.within(0.15) - kWall;
  };
  EXPECT_NEAR(most(0.004), WallPass::kDeepest, 1e-6);
  EXPECT_NEAR(most(0.008), WallPass::kOfThickness * 0.008, 1e-6);
  EXPECT_NEAR(most(0.03), WallPass::kMost, 1e-6);
  WallPass pass;
  pass.begin(both_hands(clay), clay, 0.06);
  go(pass, clay, 0.06, 0.12);
  go(pass, clay, 0.12, 0.10);
  EXPECT_NEAR(pass.within(0.15), kWall + WallPass::kEvening, 1e-6);
  go(pass, clay, 0.10, 0.004);
  pass.begin(both_hands(clay), clay, 0.02);
  go(pass, clay, 0.02, 0.004);
  EXPECT_NEAR(pass.within(0.15), kWall + WallPass::kDeepest, 1e-6) << "the foot is solid";
}

// A hand that comes to its depth on the spot leaves a step in the wall.
TEST(WallPass, HandsEaseIntoTheClayAlongTheirWay) {
  const ClayView clay = lump();
  const WallHold hold = both_hands(clay);
  WallPass pass;
  pass.begin(hold, clay, 0.06);
  constexpr double kWay = 0.05 * kFrame;
  double last = 0, last_step = 0;
  for (int n = 1; n <= 90; ++n) {
    pass.go(hold, clay, 0.06 + kWay * n, 0.1, kFrame);
    const double depth = pass.reach() - kWall, step = depth - last;
    EXPECT_LE(step, WallPass::kSlope * kWay + WallPass::kDeeper * kFrame + 1e-9) << n;
    EXPECT_LT(std::abs(step - last_step), 0.25 * kWay) << n << ": no corner either";
    last = depth;
    last_step = step;
  }
  EXPECT_NEAR(last, WallPass::kDeepest, 1e-5);
}

TEST(WallPass, HandsThatAreLetGoOfComeOutOfTheClayAsTheyGoOn) {
  const ClayView clay = lump();
  const WallHold hold = both_hands(clay);
  for (const double wanted : {kWall + 0.006, 0.1}) {
    WallPass pass;
    pass.begin(hold, clay, 0.04);
    go(pass, clay, 0.04, 0.12, wanted);
    const double deep = pass.reach() - kWall;
    ASSERT_GT(deep, 0.0055);
    pass.ease_out();
    double last = deep, way = 0;
    for (; !pass.out() && way < 0.1; way += 0.001) {
      pass.go(hold, clay, 0.12 + way, wanted, kFrame);
      EXPECT_LE(pass.reach() - kWall, last + 1e-9);
      EXPECT_GT(pass.reach() - kWall, last - 0.0013) << "no step";
      last = pass.reach() - kWall;
    }
    EXPECT_NEAR(last, 0, 1e-4);
    EXPECT_NEAR(way, std::min(2 * deep, WallPass::kOut), 0.0025);
  }
}

// What is evened is the wall as it stands when they come back, not as it was before the pass.
TEST(WallPass, EachPassBeginsFromTheWallAsItThenStands) {
  ClayView clay = lump();
  WallPass pass;
  pass.begin(both_hands(clay), clay, 0.06);
  go(pass, clay, 0.06, 0.12);
  ClayDef wider;
  wider.rows = 100;
  wider.sectors = 16;
  wider.outer_radius = 0.062;
  wider.inner_radius = 0.052;
  clay.lay(wider);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest, 1e-6);
  go(pass, clay, 0.12, 0.10);
  EXPECT_NEAR(pass.within(0.1), 0.062 + WallPass::kEvening, 1e-6);
}

TEST(WallPass, AHandThatTremblesIsOnOnePass) {
  const ClayView clay = lump();
  const WallHold hold = both_hands(clay);
  WallPass pass;
  pass.begin(hold, clay, 0.06);
  for (int n = 0; n < 600; ++n) {
    const double tremble = (n % 2 == 0 ? 0.4 : -0.4) * WallPass::kBack;
    pass.go(hold, clay, 0.06 + 0.0001 * n + tremble, kWall, kFrame);
  }
  EXPECT_EQ(pass.backs(), 0);
}

TEST(WallPass, WhoLingersPressesOnAndWhoGoesOnDoesNot) {
  const ClayView clay = lump();
  const WallHold hold = both_hands(clay);
  WallPass pass;
  pass.begin(hold, clay, 0.1);
  for (int n = 0; n < 60; ++n) pass.go(hold, clay, 0.1, kWall, kFrame);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest + WallPass::kPressOn - WallPass::kStay,
              1e-6);
  go(pass, clay, 0.1, 0.12);
  EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest, 1e-6);
}

// Else hands that only even would carry every ridge along.
TEST(WallPass, ARidgeIsNotSeenAsTheWall) {
  ClayDef def;
  def.rows = 200;
  def.sectors = 16;
  def.inner_radius = kWall - 0.005;
  Clay ringed = Clay::create(def).value();
  for (int j = 0; j < 200; ++j)
    for (float& r : ringed.outer_mut(j)) r += j / 3 % 2 == 0 ? 0.002f : -0.002f;
  ClayView clay;
  clay.take(ringed);
  WallPass pass;
  pass.begin(both_hands(clay), clay, 0.05);
  for (int n = 0; n < 50; ++n) {
    pass.go(both_hands(clay), clay, 0.05 + 0.002 * n, kWall, kFrame);
    EXPECT_NEAR(pass.within(0.1), kWall + WallPass::kDeepest, 0.001) << n;
  }
}

// A wall that is pulled up takes its places along: half-way up stays half-way up.
TEST(WallPass, AWallThatRisesIsRememberedByItsShareOfTheHeight) {
  WallHold hold({2, 0.018}, {0, 0.008});
  ClayDef foot;
  foot.rows = 100;
  foot.sectors = 16;
  foot.height = 0.1;
  foot.inner_radius = 0.035;
  Clay stepped = Clay::create(foot).value();
  for (int j = 50; j < 100; ++j)
    for (float& r : stepped.outer_mut(j)) r = 0.04f;
  ClayView clay;
  clay.take(stepped);
  hold.take(clay, Grip::outside, 0.02);
  WallPass pass;
  pass.begin(hold, clay, 0.02);
  const ClayView risen = lump(0.2);
  pass.go(hold, risen, 0.05, kWall, kFrame);
  EXPECT_NEAR(pass.within(0.0), kWall - WallPass::kMost, 1e-6);
  pass.go(hold, risen, 0.15, kWall, kFrame);
  EXPECT_NEAR(pass.within(0.0), 0.04 - WallPass::kDeepest, 1e-6);
}

}  // namespace
}  // namespace onggi::device::wall_pass_test

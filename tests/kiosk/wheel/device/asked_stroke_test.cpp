#include "kiosk/wheel/device/asked_stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kiosk/wheel/device/tube.h"

namespace onggi::device::asked_stroke_test {
namespace {

constexpr double kHeight = 0.2;

Profile straight(double radius) {
  Profile p;
  for (int n = 0; n <= 100; ++n) p.points.push_back({kHeight * n / 100, radius, radius - 0.005});
  return p;
}

double most(const Stroke& stroke, double radius) {
  double far = 0;
  for (const Vec2& at : stroke.path)
    if (std::abs(at.x - radius) > std::abs(far)) far = at.x - radius;
  return far;
}

TEST(AskedStroke, ThePartsShareEveryHeightBetweenThemAndEachIsStrongestAtItsMiddle) {
  for (int i = 0; i <= 200; ++i) {
    double sum = 0;
    for (int n = 0; n + 1 < kWallParts; ++n) sum += weight_of(static_cast<WallPart>(n), i / 200.0);
    EXPECT_NEAR(sum, 1.0, 1e-12) << i;
  }
  for (int n = 0; n < kWallParts; ++n)
    EXPECT_EQ(weight_of(static_cast<WallPart>(n), middle_of(static_cast<WallPart>(n))), 1.0);
}

TEST(AskedStroke, WidenGoesOutwardsAndNarrowInwardsAndNeitherFartherThanTheOutline) {
  EXPECT_NEAR(most(asked_stroke(tube(0.05), straight(0.09), Ask::widen, WallPart::all), 0.05),
              0.009, 1e-6);
  EXPECT_NEAR(most(asked_stroke(tube(0.05), straight(0.055), Ask::widen, WallPart::all), 0.05),
              0.005, 1e-6);
  EXPECT_NEAR(most(asked_stroke(tube(0.07), straight(0.05), Ask::narrow, WallPart::all), 0.07),
              -0.004, 1e-6);
  EXPECT_NEAR(most(asked_stroke(tube(0.07), straight(0.0675), Ask::narrow, WallPart::all), 0.07),
              -0.0025, 1e-6);
}

TEST(AskedStroke, WhoAsksAtTheOutlineGoesOnBeyondIt) {
  for (const double target : {0.05, 0.04}) {
    const auto stroke = asked_stroke(tube(0.05), straight(target), Ask::widen, WallPart::middle);
    EXPECT_NEAR(most(stroke, 0.05), 0.003, 1e-6);
  }
  for (const double target : {0.05, 0.06}) {
    const auto stroke = asked_stroke(tube(0.05), straight(target), Ask::narrow, WallPart::middle);
    EXPECT_NEAR(most(stroke, 0.05), -0.002, 1e-6);
  }
}

TEST(AskedStroke, APartIsWorkedAtItsHeightAndFadesIntoItsNeighbours) {
  for (int n = 0; n + 1 < kWallParts; ++n) {
    const auto part = static_cast<WallPart>(n);
    const auto stroke = asked_stroke(tube(0.05), straight(0.09), Ask::widen, part);
    ASSERT_FALSE(stroke.path.empty());
    double last = 0;
    for (const Vec2& at : stroke.path) {
      EXPECT_NEAR(at.x - 0.05, 0.009 * weight_of(part, at.y / kHeight), 1e-6);
      EXPECT_TRUE(last == 0 || std::abs(at.x - last) < 0.0015) << "no ledge";
      last = at.x;
      EXPECT_GT(weight_of(part, at.y / kHeight), 0.0) << "nothing is touched that was not asked";
    }
  }
}

TEST(AskedStroke, AThickWallIsOpenedFromInsideWhicheverWayOutwardsIsAsked) {
  for (const Ask ask : {Ask::open, Ask::widen}) {
    const auto stroke = asked_stroke(tube(0.055, 0.03), straight(0.07), ask, WallPart::low);
    EXPECT_EQ(stroke.kind, Stroke::Kind::open);
    EXPECT_EQ(stroke.grip, Grip::inside);
  }
  EXPECT_NE(asked_stroke(tube(0.055, 0.03), straight(0.04), Ask::narrow, WallPart::low).grip,
            Grip::inside);
}

TEST(AskedStroke, PullingUpSqueezesAndLeavesTheOutsideWhereItIsAndEveningSqueezesNothing) {
  for (const Ask ask : {Ask::pull, Ask::even}) {
    const auto stroke = asked_stroke(tube(0.05), straight(0.09), ask, WallPart::all);
    EXPECT_NEAR(most(stroke, 0.05), 0, 1e-9);
    EXPECT_EQ(stroke.squeeze < 1, ask == Ask::pull);
    EXPECT_LT(stroke.path.front().y, stroke.path.back().y) << "from the foot up";
  }
}

}  // namespace
}  // namespace onggi::device::asked_stroke_test

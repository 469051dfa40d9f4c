#include "kiosk/wheel/device/stroke_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/kiosk/wheel/device/tube.h"

namespace onggi::device::stroke_plan_test {
namespace {

Profile jar(double radius, double belly) {
  Profile p;
  for (int n = 0; n <= 100; ++n) {
    const double r = radius + belly * std::sin(3.14159265 * n / 100);
    p.points.push_back({0.002 * n, r, r - 0.005});
  }
  return p;
}

TEST(StrokePlan, AThickWallIsOpenedFromInsideBeforeItIsBroughtAnywhere) {
  const auto stroke = next_stroke(tube(0.055, 0.03), jar(0.055, 0.03), 0.001);
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->kind, Stroke::Kind::open);
  EXPECT_EQ(stroke->grip, Grip::inside);
  for (const Vec2& at : stroke->path) {
    EXPECT_GE(at.x, 0.025 - 1e-6);
    EXPECT_LE(at.x, 0.055 - 0.008 + 1e-6);  // never through the wall
  }
}

TEST(StrokePlan, BothHandsWidenTowardsABellyAndNarrowTowardsANeckFromTheFootUp) {
  const auto wide = next_stroke(tube(0.055, 0.006), jar(0.055, 0.03), 0.001);
  const auto slim = next_stroke(tube(0.055, 0.006), jar(0.055, -0.02), 0.001);
  ASSERT_TRUE(wide && slim);
  EXPECT_EQ(wide->kind, Stroke::Kind::belly);
  EXPECT_EQ(slim->kind, Stroke::Kind::collar);
  for (const auto* stroke : {&*wide, &*slim}) {
    EXPECT_EQ(stroke->grip, Grip::both);
    for (std::size_t n = 1; n < stroke->path.size(); ++n)
      EXPECT_GT(stroke->path[n].y, stroke->path[n - 1].y);
  }
  for (const Vec2& at : wide->path) EXPECT_TRUE(at.x > 0.0549 && at.x < 0.0641) << at.y;
  for (const Vec2& at : slim->path) EXPECT_TRUE(at.x < 0.0551 && at.x > 0.0469) << at.y;
}

TEST(StrokePlan, EveryHeightGoesTheSameShareOfWhatIsLeftToIt) {
  const ClayView clay = tube(0.055, 0.006);
  const Profile target = jar(0.055, 0.04);
  const auto stroke = next_stroke(clay, target, 0.001, 0.005);
  ASSERT_TRUE(stroke);
  double most = 0;
  for (const Vec2& at : stroke->path) {
    const double left = target.outer_at(at.y) - 0.055, gone = at.x - 0.055;
    most = std::max(most, gone);
    // Over the foot it sets in.
    if (at.y > 0.04) {
      EXPECT_NEAR(gone / left, 0.005 / 0.04, 0.002) << at.y;
    }
  }
  EXPECT_NEAR(most, 0.005, 1e-4);
}

TEST(StrokePlan, ABallRolledAlongAVesselFillsWhatIsNarrowerThanItselfAndNothingElse) {
  // A tube with a groove of 10 mm round it, and a sharp shoulder up to a neck.
  Profile p;
  for (int n = 0; n <= 400; ++n) {
    const double h = 0.0005 * n;
    const double r = h > 0.16 ? 0.02 : std::abs(h - 0.08) < 0.005 ? 0.04 : 0.05;
    p.points.push_back({h, r, 0.01});
  }
  constexpr double kBall = 0.018;
  const Profile out = rolled(p, kBall);
  EXPECT_NEAR(out.outer_at(0.03), 0.05, 1e-6);
  // A ball lies on the groove's edges, and dips in by r - sqrt(r^2 - (w / 2)^2).
  EXPECT_NEAR(out.outer_at(0.08), 0.05 - (kBall - std::sqrt(kBall * kBall - 25e-6)), 1e-4);
  // In the corner under the neck it touches both: the neck a radius above the shoulder's edge.
  EXPECT_NEAR(out.outer_at(0.16 + kBall), 0.02, 1e-3);
  EXPECT_NEAR(out.outer_at(0.164), 0.038 - std::sqrt(kBall * kBall - 0.014 * 0.014), 0.002);
  for (double h = 0; h <= 0.2; h += 0.001) {
    EXPECT_GE(out.outer_at(h) + 2e-4, std::min(p.outer_at(h - 0.001), p.outer_at(h + 0.001))) << h;
    EXPECT_NEAR(rolled(out, kBall).outer_at(h), out.outer_at(h), 3e-4) << h;
    EXPECT_EQ(out.inner_at(h), 0.01);
  }
}

TEST(StrokePlan, TheFootIsLeftAloneAndNothingIsLeftToDoOnAPotThatIsThere) {
  const auto stroke = next_stroke(tube(0.055, 0.006), jar(0.02, 0.06), 0.001);
  ASSERT_TRUE(stroke);
  EXPECT_GT(stroke->path.front().y, 0.01);
  EXPECT_FALSE(next_stroke(tube(0.055, 0.006), jar(0.055, 0.0005), 0.001));
}

TEST(StrokePlan, StrokeAfterStrokeAWallThatFollowsComesToTheOutline) {
  ClayView clay = tube(0.055, 0.006);
  const Profile target = jar(0.06, 0.035);
  int strokes = 0;
  while (const auto stroke = next_stroke(clay, target, 0.001)) {
    ASSERT_LT(++strokes, 12);
    for (int j = 0; j < clay.rows(); ++j) {
      const auto near = std::ranges::min_element(
          stroke->path, {}, [&](const Vec2& at) { return std::abs(at.y - clay.row_height(j)); });
      if (std::abs(near->y - clay.row_height(j)) > 0.0015) continue;
      const auto face = static_cast<float>(near->x);
      clay.shape(j, std::vector<float>(16, face), std::vector<float>(16, face - 0.006f));
    }
  }
  EXPECT_NEAR(clay.radius_at(0.1, WallSide::outside), target.outer_at(0.1), 0.001);
}

}  // namespace
}  // namespace onggi::device::stroke_plan_test

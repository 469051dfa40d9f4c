#include "engine/contact/bodies/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/bodies/capsule.h"
#include "engine/contact/bodies/cylinder.h"
#include "engine/math/random.h"
#include "tests/support/any_direction.h"

namespace onggi::body::bounds_test {
namespace {

TEST(Bounds, AnOutlineThatIsNothingButRoundingSpansWhatTheTouchSpans) {
  // The corner of a block, a float's last digits large: nothing by nothing is no direction.
  const Turn coarse{0.3, 0.01};
  for (const float size : {1e-9f, 4e-10f, 1e-12f, 1e-38f}) {
    Outline corner;
    corner.x = 0.05f;
    corner.z = 0.016f;
    corner.ux = size;
    for (const WallSide side : {WallSide::outside, WallSide::inside}) {
      const Turn turn = turn_of(corner, side, 0.05, coarse);
      EXPECT_EQ(turn.middle, coarse.middle) << size;
      EXPECT_EQ(turn.half, coarse.half) << size;
    }
  }
}

TEST(Bounds, AFlatDiscIsHeldByASquareOfItsOwnSize) {
  const Hull hull = Cylinder({0.05, 0.1, 0.0}, {0.0, 1.0, 0.0}, 0.03, 0.002).hull();
  ASSERT_EQ(hull.count, 8);
  for (const Vec3& corner : hull.middle) {
    EXPECT_NEAR(length(Vec2{corner.x - 0.05, corner.z}), std::sqrt(2.0) * 0.03, 1e-12);
    EXPECT_NEAR(std::fabs(corner.y - 0.1), 0.002, 1e-12);
  }
}

TEST(Approach, NoPointOfARodOrADiscIsNearerToTheAxisThanItIsToldOfItsHeight) {
  Random random(5);
  int known = 0;
  for (int n = 0; n < 400; ++n) {
    const Vec3 middle{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                      random.uniform(-0.1, 0.1)};
    const Vec3 axis = test::any_direction(random);
    const double radius = random.uniform(0.001, 0.05), half = random.uniform(0.001, 0.05);
    const Approach of_rod = Capsule{middle, axis, half, radius}.approach();
    const Approach of_disc = Cylinder(middle, axis, radius, half).approach();
    known += of_rod.nearest(middle.y) > -1.0;
    known += of_disc.nearest(middle.y) > -1.0;
    for (int k = 0; k < 200; ++k) {
      // At its surface, for there it is nearest.
      const Vec3 out = test::any_direction(random);
      const Vec3 on_rod = middle + random.uniform(0.0, half) * axis + radius * out;
      EXPECT_GE(axis_distance(on_rod), of_rod.nearest(on_rod.y)) << n;
      const Vec3 flat = out - dot(out, axis) * axis;
      const Vec3 on_disc = middle + random.uniform(-half, half) * axis +
                           (radius / std::max(length(flat), 1e-9)) * flat;
      EXPECT_GE(axis_distance(on_disc), of_disc.nearest(on_disc.y)) << n;
    }
  }
  EXPECT_GT(known, 700);
}

TEST(Approach, IsExactOfADiscOnEdgeAndOfARodThatLeansOutwards) {
  const double radius = 0.04, half = 0.002;
  for (const double turned : {0.0, 0.7, 4.0}) {
    const double c = std::cos(turned), s = std::sin(turned);
    const Vec3 disc{0.1 * c, 0.05, 0.1 * s};
    // Its edge towards the axis, its face, and leaning over by an angle of sine 0.6.
    const Approach edge = Cylinder(disc, {-s, 0.0, c}, radius, half).approach();
    const Approach face = Cylinder(disc, {c, 0.0, s}, radius, half).approach();
    const Approach leaning = Cylinder(disc, {0.8 * c, 0.6, 0.8 * s}, radius, half).approach();
    const Approach rod = Capsule{disc, {0.6 * c, 0.8, 0.6 * s}, 0.1, 0.003}.approach();
    for (const double up : {0.01, 0.03}) {
      const double chord = std::sqrt(radius * radius - up * up);
      EXPECT_NEAR(edge.nearest(disc.y + up), 0.1 - chord, 2e-6);
      EXPECT_NEAR(face.nearest(disc.y + up), 0.1 - half, 2e-6);
      EXPECT_NEAR(face.nearest(disc.y - up), 0.1 - half, 2e-6);
      EXPECT_NEAR(leaning.nearest(disc.y + 0.5 * up), 0.1 - 0.75 * 0.5 * up - half / 0.8, 2e-6);
      EXPECT_NEAR(rod.nearest(disc.y + up), 0.1 + 0.75 * up - 0.003 / 0.8, 2e-6);
    }
  }
}

TEST(Approach, OfALeaningDiscComesWithinHalfAMillimetre) {
  // A sheet whose level chords point at the axis: it leans aside.
  const Approach sheet = Cylinder({0.1, 0.05, 0.0}, {0.0, 0.6, 0.8}, 0.04, 1e-6).approach();
  for (const double up : {-0.025, -0.01, 0.0, 0.01, 0.025}) {
    const double chord = std::sqrt(0.04 * 0.04 - up * up / 0.64);
    const double true_nearest = std::hypot(0.1 - chord, 0.75 * up);
    EXPECT_NEAR(sheet.nearest(0.05 + up), true_nearest, 1e-5 + 0.03 * std::fabs(up));
  }
}

TEST(Approach, OfWhatLiesNearlyLevelNothingIsTold) {
  const double rise = 0.099, level = std::sqrt(1.0 - rise * rise);
  EXPECT_LT((Capsule{{0.1, 0, 0}, {level, rise, 0.0}, 0.1, 0.003}.approach().nearest(0.0)), -1.0);
  EXPECT_LT(Cylinder({0.1, 0, 0}, {rise, level, 0.0}, 0.04, 0.002).approach().nearest(0.0), -1.0);
  // Nor where a section's middle is on the axis: it has no direction.
  EXPECT_LT((Capsule{{0, 0, 0}, {0.0, 1.0, 0.0}, 0.1, 0.003}.approach().nearest(0.0)), -1.0);
}

}  // namespace
}  // namespace onggi::body::bounds_test

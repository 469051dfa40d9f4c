#include "kiosk/exhibit/composition/cones.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::exhibit::cones_test {
namespace {

std::vector<Vec2> along(std::vector<Vec2> corners) { return evenly_along(corners, 201); }

TEST(Cones, ACylinderAndAConeAreOneZoneWithoutError) {
  for (const auto& outline : {along({{0.05, 0}, {0.05, 0.2}}), along({{0.03, 0}, {0.09, 0.1}}),
                              along({{0.09, 0}, {0.02, 0.01}})}) {
    const auto cones = cones_of(outline, 1e-4, 6);
    ASSERT_EQ(cones.size(), 1u);
    EXPECT_LT(cones[0].error, 1e-9);
    EXPECT_EQ(cones[0].first, 0u);
    EXPECT_EQ(cones[0].last, 200u);
    const Vec2 way = outline.back() - outline.front();
    EXPECT_NEAR(dot(cones[0].along, way), length(way), 1e-9) << "its direction is the outline's";
  }
}

TEST(Cones, TwoConesThatMeetAreFoundWhereTheyMeet) {
  // 100 mm and 100 mm.
  const auto cones = cones_of(along({{0.03, 0}, {0.09, 0.08}, {0.03, 0.16}}), 1e-4, 6);
  ASSERT_EQ(cones.size(), 2u);
  EXPECT_EQ(cones[0].last, 100u);
  EXPECT_EQ(cones[1].first, 100u);
  EXPECT_GT(cones[0].along.x, 0.5);
  EXPECT_LT(cones[1].along.x, -0.5);
}

TEST(Cones, TheErrorOfAnArcIsThatOfItsChordsBestLine) {
  // A quarter of a circle of 50 mm in z zones: a zone spans 90/z degrees, and its arc bulges by
  // r (1 - cos(45/z)); the best line divides that.
  std::vector<Vec2> arc;
  for (int n = 0; n <= 400; ++n) {
    const double angle = 0.5 * 3.14159265358979 * n / 400;
    arc.push_back({0.02 + 0.05 * std::sin(angle), 0.05 - 0.05 * std::cos(angle)});
  }
  const auto cones = cones_of(evenly_along(arc, 181), 0.0, 3);
  ASSERT_EQ(cones.size(), 3u);
  const double bulge = 0.05 * (1.0 - std::cos(3.14159265358979 / 12.0));
  for (const Cone& cone : cones) {
    EXPECT_LT(cone.error, bulge);
    EXPECT_GT(cone.error, 0.5 * bulge);
    EXPECT_NEAR(static_cast<double>(cone.last - cone.first), 60.0, 3.0);
  }
}

TEST(Cones, NoMoreZonesThanAreAllowedOrNeeded) {
  std::vector<Vec2> jar;
  for (int n = 0; n <= 300; ++n)
    jar.push_back({0.05 + 0.03 * std::sin(3.0 * n / 300.0), 0.18 * n / 300.0});
  const auto even = evenly_along(jar, 201);
  double before = 1.0;
  for (int most = 1; most <= 5; ++most) {
    const auto cones = cones_of(even, 0.0, most);
    ASSERT_EQ(static_cast<int>(cones.size()), most);
    double worst = 0.0;
    std::size_t next = 0;
    for (const Cone& cone : cones) {
      EXPECT_EQ(cone.first, next) << "zones share their ends";
      next = cone.last;
      worst = std::max(worst, cone.error);
    }
    EXPECT_EQ(next, 200u);
    EXPECT_LT(worst, before);
    before = worst;
  }
  EXPECT_LT(cones_of(even, 1e-3, 6).size(), 6u);
}

}  // namespace
}  // namespace onggi::exhibit::cones_test

#include "engine/profile/capacity.h"

#include <gtest/gtest.h>

#include "engine/profile/mesh.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::capacity_test {
namespace {

constexpr double kPiHere = 3.14159265358979323846;

TEST(ProfileCapacity, OfACylinderAndAFrustumAreThoseOfTheSolids) {
  EXPECT_NEAR(capacity(shapes::cylinder(0.11, 0.056, 0.05, 0.01)) / (kPiHere * 0.0025 * 0.1), 1.0,
              2e-4);
  Profile cone;
  cone.points = {{0, 0.04, 0}, {0.01, 0.04, 0.03}, {0.13, 0.08, 0.07}};
  EXPECT_NEAR(capacity(cone), kPiHere * 0.12 / 3 * (0.0009 + 0.0021 + 0.0049), 1e-12);
}

// The turned clay and what it holds are together the solid of the outline.
TEST(ProfileCapacity, AndTheMeshOfItsClayFillTheOutline) {
  for (const Profile& p : {shapes::jar(), shapes::bottle(), shapes::bowl()}) {
    double solid = 0.0;
    for (std::size_t n = 1; n < p.points.size(); ++n) {
      const double a = p.points[n - 1].outer, b = p.points[n].outer;
      solid +=
          kPiHere / 3 * (p.points[n].height - p.points[n - 1].height) * (a * a + a * b + b * b);
    }
    const double clay = shapes::volume(revolve(section_of(p), 720));
    EXPECT_NEAR((capacity(p) + clay) / solid, 1.0, 0.003);
  }
}

TEST(ProfileCapacity, OfWhatIsSolidOrEmptyIsNothing) {
  Profile rod;
  EXPECT_EQ(capacity(rod), 0.0);
  rod.points = {{0, 0.04, 0}, {0.1, 0.04, 0}};
  EXPECT_EQ(capacity(rod), 0.0);
}

}  // namespace
}  // namespace onggi::capacity_test

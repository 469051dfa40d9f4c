#include "engine/surface/outline_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::outline_rows_test {
namespace {

TEST(Outline, GoesFromTheFootOverTheLipToTheFloorInRowsOfAQuarterMillimetre) {
  const Surface bowl_surface = made(bowl());
  Part last = Part::outside;
  std::array<int, 4> rows{};
  for (int j = 0; j < bowl_surface.rows(); ++j) {
    const Row& row = bowl_surface.row(j);
    ASSERT_GE(row.part, last);
    last = row.part;
    ++rows[static_cast<std::size_t>(row.part)];
  }
  // By hand: slopes of 4 and 6, 21 and 34, 3 and 20 mm outside; 4 mm of lip; 18 - 6 mm of floor.
  EXPECT_NEAR(rows[0], (std::hypot(4.0, 6.0) + std::hypot(21.0, 34.0) + std::hypot(3.0, 20.0)) * 4,
              1.0);
  EXPECT_NEAR(rows[1], 4.0 * 4, 1.0);
  EXPECT_NEAR(rows[2], (std::hypot(2.0, 20.0) + std::hypot(22.0, 34.0)) * 4, 1.0);
  EXPECT_NEAR(rows[3], 12.0 * 4, 1.0);
}

TEST(Outline, RowsLieOnTheProfile) {
  const Profile profile = jar();
  const Surface surface = made(profile);
  for (int j = 0; j < surface.rows(); ++j) {
    const Row& row = surface.row(j);
    if (row.part == Part::outside) {
      ASSERT_NEAR(row.radius, profile.outer_at(row.height), 1e-12);
    }
    if (row.part == Part::inside) {
      ASSERT_NEAR(row.radius, profile.inner_at(row.height), 1e-12);
    }
    if (row.part == Part::floor) {
      ASSERT_EQ(row.height, profile.floor_height());
    }
    ASSERT_NEAR(row.width, 2.0 * 3.14159265358979 * row.radius / kSectors * 1e9, 1.0);
    ASSERT_GE(row.radius, kLeastRadius);
    ASSERT_GT(row.area, 0);
  }
}

TEST(Outline, AWallIsMeasuredAcrossItsSlope) {
  const Surface surface = made(bowl());
  for (int j = 0; j < surface.rows(); ++j) {
    const Row& row = surface.row(j);
    if (row.part != Part::outside || row.height < 0.041) continue;
    const double thick = bowl().outer_at(row.height) - bowl().inner_at(row.height);
    ASSERT_NEAR(row.wall, thick * 1e6 * 20.0 / std::hypot(3.0, 20.0), 1.0);
  }
}

TEST(Outline, ASolidPotEndsOnItsTop) {
  const Surface surface = made({{{0.0, 0.030, 0.0}, {0.050, 0.030, 0.0}}});
  EXPECT_EQ(surface.row(surface.rows() - 1).part, Part::lip);
  EXPECT_NEAR(surface.rows(), (50 + 24) * 4, 1);
}

TEST(Outline, NothingLiesBeyondANarrowPlace) {
  const Surface surface = made({{{0.0, 0.030, 0.0}, {0.050, 0.004, 0.0}, {0.100, 0.030, 0.0}}});
  for (int j = 0; j < surface.rows(); ++j) ASSERT_LT(surface.row(j).height, 0.050);
}

TEST(Outline, APotThatCannotBeDecoratedIsOneProblem) {
  const auto fault = [](const Profile& profile) {
    const Result<Surface> surface = Surface::create(profile, "moon jar");
    EXPECT_FALSE(surface);
    return surface ? std::string() : to_text(surface.error());
  };
  EXPECT_EQ(fault({}),
            "moon jar: the profile has 0 points, but a wall needs at least two.\n"
            "  Give the radius at the foot and at the rim.");
  EXPECT_EQ(fault({{{0.0, 0.005, 0.0}, {0.1, 0.005, 0.0}}}),
            "moon jar: its foot is within 6 mm of the axis, so there is nothing to decorate.\n"
            "  Give radii in metres.");
  EXPECT_EQ(fault({{{0.0, 0.5, 0.0}, {2.5, 0.5, 0.4}}}),
            "moon jar: its outline is longer than 2 m, too long to be decorated.\n"
            "  Scale the pot to the wheel first.");
}

}  // namespace
}  // namespace onggi::surface_test::outline_rows_test

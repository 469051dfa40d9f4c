#include "kiosk/collection/decoration/relief.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/surface/laws.h"

namespace onggi::decoration::relief_test {
namespace {

/// A straight cup, 50 mm in radius and 60 mm high.
surface::Surface cup() {
  Profile profile;
  for (int n = 0; n <= 12; ++n) {
    const double height = 0.005 * n;
    profile.points.push_back({height, 0.05, height < 0.008 ? 0.0 : 0.044});
  }
  profile.inner_wall = InnerWall::measured;
  auto surface = surface::Surface::create(profile, "cup");
  EXPECT_TRUE(surface);
  return std::move(*surface);
}

/// A ramp of 1 : 2 over rows 80 to 99, or over sectors 400 to 419 of rows 40 to 60.
surface::Surface ramped(bool along) {
  surface::Surface surface = cup();
  if (along)
    for (int j = 80; j < 100; ++j)
      for (int i = 0; i < surface::kSectors; ++i)
        surface.set_relief(j, i, -(j - 80) * surface::kRowHeight / 2);
  else
    for (int j = 40; j < 60; ++j)
      for (int i = 400; i < 420; ++i)
        surface.set_relief(j, i, -(i - 400) * surface.row(j).width / 2000);
  return surface;
}

struct Normal {
  double x, y, z;
};
Normal normal_at(const Unrolled& picture, int x, int y) {
  const auto at = 4u * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(x));
  const auto part = [&](std::size_t k) { return picture.rgba[at + k] / 127.5 - 1.0; };
  return {part(0), part(1), part(2)};
}

TEST(Relief, BareClayFacesStraightOutEverywhere) {
  const surface::Surface surface = cup();
  const Unrolled picture = normals_of(surface, 128, 64, 1.0);
  ASSERT_EQ(picture.rgba.size(), 4u * 128u * 64u);
  for (std::size_t n = 0; n < picture.rgba.size(); n += 4) {
    EXPECT_EQ(picture.rgba[n], 128);
    EXPECT_EQ(picture.rgba[n + 1], 128);
    EXPECT_EQ(picture.rgba[n + 2], 255);
    EXPECT_EQ(picture.rgba[n + 3], 255);
  }
}

TEST(Relief, ACutThatDeepensUpThePotFacesUpThere) {
  // Its floor sinks towards the lip by 1 : 2, so it faces the lip: away from the picture's top.
  const surface::Surface surface = ramped(true);
  const Unrolled picture = normals_of(surface, surface::kSectors, surface.rows(), 1.0);
  const Normal n = normal_at(picture, 700, 90);
  EXPECT_NEAR(n.x, 0.0, 0.01);
  EXPECT_NEAR(n.y, -0.5 / std::sqrt(1.25), 0.01);
  EXPECT_NEAR(n.z, 1.0 / std::sqrt(1.25), 0.01);
}

TEST(Relief, ACutThatDeepensRoundThePotFacesOnInTheDirectionOfTheSectors) {
  const surface::Surface surface = ramped(false);
  const Unrolled picture = normals_of(surface, surface::kSectors, surface.rows(), 1.0);
  const Normal n = normal_at(picture, 410, 50);
  EXPECT_NEAR(n.x, 0.5 / std::sqrt(1.25), 0.01);
  EXPECT_NEAR(n.y, 0.0, 0.01);
}

TEST(Relief, GlassThatRunsLevelLeavesAShareOfTheSlope) {
  const surface::Surface surface = ramped(true);
  const Unrolled picture = normals_of(surface, surface::kSectors, surface.rows(), 0.2);
  EXPECT_NEAR(normal_at(picture, 700, 90).y, -0.1 / std::sqrt(1.01), 0.01);
}

TEST(Relief, AVCutIsSeenWithBothItsWallsWhereTheToolWent) {
  surface::Surface surface = cup();
  surface::CutDef def;
  def.section = surface::CutDef::v, def.width = 4e-3, def.depth = 1e-3, def.burr = 0.0;
  surface::Stroke ring{def, {}, false};
  for (int n = 0; n <= 4 * 140; ++n) {
    surface::Station at;
    at.along = 30000, at.round = n * 3 * surface::kParts;
    ring.stations.push_back(at);
  }
  const auto done = surface::apply(surface, ring);
  ASSERT_TRUE(done) << to_text(done.error());
  const Unrolled picture = normals_of(surface, 1024, 512, 1.0);
  const auto row_of = [&](double mm) {
    return static_cast<int>(mm / 0.25 / surface.rows() * picture.height);
  };
  // 1 mm deep over 2 mm. Below the middle the wall sinks towards the lip, above it rises.
  EXPECT_NEAR(normal_at(picture, 300, row_of(29.0)).y, -0.447, 0.06);
  EXPECT_NEAR(normal_at(picture, 300, row_of(31.0)).y, 0.447, 0.06);
  EXPECT_NEAR(normal_at(picture, 300, row_of(25.0)).y, 0.0, 0.01);
  EXPECT_NEAR(height_at(surface, 0.3, 30.0 / 0.25 / surface.rows()), -1e-3, 1.2e-4);
}

// Rounding to whole steps of a slip glittered under a viewer's gloss.
TEST(Relief, AnEvenCoatOfSlipIsSmooth) {
  surface::Surface surface = cup();
  surface::BrushDef brush;
  brush.width = 0.03, brush.tracks = 1;
  surface::Stroke ring{brush, {}, false};
  for (int n = 0; n <= 4 * 140; ++n) {
    surface::Station at;
    at.along = 30000, at.round = n * 3 * surface::kParts;
    ring.stations.push_back(at);
  }
  for (int n = 0; n < 3; ++n) ASSERT_TRUE(surface::apply(surface, ring));
  const Unrolled picture = normals_of(surface, surface::kSectors, surface.rows(), 1.0);
  double tilted = 0.0, cells = 0.0;
  for (int y = 100; y < 140; ++y)
    for (int x = 200; x < 1400; ++x, ++cells)
      tilted += std::acos(std::min(1.0, normal_at(picture, x, y).z));
  EXPECT_LT(tilted / cells, 0.05);
}

TEST(Relief, ASmallPotHasPixelsWithinACell) {
  const surface::Surface surface = ramped(true);
  const Unrolled picture = normals_of(surface, 2 * surface::kSectors, 3 * surface.rows(), 1.0);
  EXPECT_NEAR(normal_at(picture, 1400, 3 * 90 + 1).y, -0.447, 0.01);
}

TEST(Relief, HeightsLieStraightBetweenTheMiddlesOfCellsAndGoRound) {
  surface::Surface surface = cup();
  surface.set_relief(50, 0, 400);
  surface.set_relief(50, surface::kSectors - 1, 200);
  const double row = 50.5 / surface.rows();
  EXPECT_NEAR(height_at(surface, 0.5 / surface::kSectors, row), 4e-4, 1e-12);
  EXPECT_NEAR(height_at(surface, 0.0, row), 3e-4, 1e-12);
  EXPECT_NEAR(height_at(surface, 1.0, row), 3e-4, 1e-12);
  EXPECT_NEAR(height_at(surface, 0.5 / surface::kSectors, 51.0 / surface.rows()), 2e-4, 1e-12);
  EXPECT_EQ(height_at(surface, 0.5, row), 0.0);
}

TEST(Relief, AMeanIsOverTheCellsOfItsField) {
  surface::Surface surface = cup();
  for (int i = 0; i < 10; ++i) surface.set_relief(50, i, 100);
  const double row = 50.5 / surface.rows(), cell = 1.0 / surface::kSectors;
  EXPECT_NEAR(mean_height(surface, 5 * cell, row, 10 * cell, 1.0 / surface.rows()), 1e-4, 1e-12);
  EXPECT_NEAR(mean_height(surface, 5 * cell, row, 20 * cell, 1.0 / surface.rows()), 5e-5, 1e-12);
  EXPECT_NEAR(mean_height(surface, 5 * cell, row, 10 * cell, 2.0 / surface.rows()), 5e-5, 1e-12);
  EXPECT_NEAR(mean_height(surface, 0.5 * cell, row, 0.0, 0.0), 1e-4, 1e-12) << "one cell at least";
}

}  // namespace
}  // namespace onggi::decoration::relief_test

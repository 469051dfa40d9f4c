#include "kiosk/collection/content/screen_model.h"

#include <gtest/gtest.h>

#include <memory>

namespace onggi::content::screen_model_test {
namespace {

/// A straight pot of `sectors`, red below and blue above, by a picture of `side` x `side`.
struct Scan {
  TriangleMesh mesh;
  Coloring coloring;

  Scan(int sectors, int side) {
    Section wall;
    wall.outline = {{0, 0}, {0.05, 0}};
    for (int i = 1; i <= 200; ++i) wall.outline.push_back({0.05, 0.1 * i / 200});
    wall.outline.push_back({0, 0.1});
    mesh = revolve(wall, sectors);
    textures::TexturePixels pixels{side, side, {}};
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const bool above = 2 * y < side;
        pixels.rgb.insert(pixels.rgb.end(), {static_cast<std::uint8_t>(above ? 0 : 255), 0,
                                             static_cast<std::uint8_t>(above ? 255 : 0)});
      }
    const auto shared = std::make_shared<textures::TexturePixels>(std::move(pixels));
    coloring.pictures = {{shared}, {shared, Coloring::Wrap::clamp}};
    for (const auto& p : mesh.positions) {
      coloring.colors.push_back({255, 255, 255});
      coloring.places.push_back({0.5f, 0.9999f - 9.998f * p[1]});
      coloring.picture.push_back(1);
    }
  }
};

TEST(ScreenModel, AVesselThatAFrameCanDrawStaysAsItIs) {
  Scan scan(100, 512);
  const Scan before = scan;
  fit_to_screen(scan.mesh, scan.coloring);
  EXPECT_EQ(scan.mesh.positions, before.mesh.positions);
  EXPECT_EQ(scan.mesh.triangles, before.mesh.triangles);
  EXPECT_EQ(scan.coloring.pictures[0].pixels, before.coloring.pictures[0].pixels);
}

TEST(ScreenModel, AScanOfAnySizeIsBroughtToWhatAFrameCanDrawAndKeepsItsShapeAndColours) {
  Scan scan(1100, 2200);
  ASSERT_GT(scan.mesh.triangles.size(), 2 * kScreenTriangles);
  fit_to_screen(scan.mesh, scan.coloring);
  EXPECT_LE(scan.mesh.triangles.size(), kScreenTriangles);
  const std::size_t count = scan.mesh.positions.size();
  EXPECT_LE(count, 3 * kScreenTriangles);
  EXPECT_EQ(scan.mesh.normals.size(), count);
  ASSERT_EQ(scan.coloring.colors.size(), count);
  float low = 1, high = 0;
  for (const auto& p : scan.mesh.positions) low = std::min(low, p[1]), high = std::max(high, p[1]);
  EXPECT_FLOAT_EQ(low, 0);
  EXPECT_NEAR(high, 0.1f, 1e-6f);
  std::size_t pixels = 0;
  for (const auto& picture : scan.coloring.pictures) pixels += picture.pixels->rgb.size() / 3;
  EXPECT_LE(pixels, kScreenPixels);
  EXPECT_GT(pixels, kScreenPixels / 8);
  ASSERT_EQ(scan.coloring.pictures.size(), 2u);
  EXPECT_EQ(scan.coloring.pictures[0].pixels, scan.coloring.pictures[1].pixels);
  const auto colors = baked(scan.coloring);
  for (std::size_t i = 0; i < count; ++i) {
    const float y = scan.mesh.positions[i][1];
    if (y < 0.048f) {
      EXPECT_EQ(colors[i], (std::array<float, 3>{1, 0, 0})) << y;
    }
    if (y > 0.052f) {
      EXPECT_EQ(colors[i], (std::array<float, 3>{0, 0, 1})) << y;
    }
  }
}

TEST(ScreenModel, PositionsThatNoTriangleHasAreDropped) {
  Scan scan(100, 16);
  const std::size_t needed = scan.mesh.positions.size();
  scan.mesh.positions.resize(1'000'000, {0, 0, 0});
  scan.mesh.normals.resize(1'000'000, {0, 1, 0});
  scan.coloring.colors.resize(1'000'000);
  scan.coloring.places.resize(1'000'000);
  scan.coloring.picture.resize(1'000'000);
  fit_to_screen(scan.mesh, scan.coloring);
  EXPECT_LE(scan.mesh.positions.size(), needed);
  for (const auto& triangle : scan.mesh.triangles)
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, scan.mesh.positions.size());
}

}  // namespace
}  // namespace onggi::content::screen_model_test

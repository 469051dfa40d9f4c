#include "kiosk/collection/decoration/unrolled.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/profile/extraction.h"
#include "kiosk/collection/decoration/decorate.h"

namespace onggi::decoration::unrolled_test {
namespace {

/// A beaker with a floor, straight walls and a flat rim, 150 mm high.
Section beaker() {
  return {{{0, 0}, {0.04, 0}, {0.05, 0.15}, {0.045, 0.15}, {0.035, 0.01}, {0, 0.01}}};
}

Decoration plain() {
  Decoration decoration;
  decoration.body = {0.5f, 0.4f, 0.3f};
  decoration.glaze = {0.5f, 0.8f, 0.5f};
  decoration.pigments = {{"white", {0.9f, 0.9f, 0.9f}, 5e-5}, {"blue", {0.0f, 0.1f, 0.6f}, 5e-5}};
  return decoration;
}

surface::Surface surface_of(const Decoration& decoration) {
  const auto found = extract_profile(revolve(beaker(), 96), {.up = Vec3{0, 1, 0}}, "beaker");
  EXPECT_TRUE(found);
  auto surface = decorated(found->profile, decoration, "beaker");
  EXPECT_TRUE(surface);
  return std::move(*surface);
}

/// sRGB, 0..255, of row j.
std::array<int, 3> color_of(const Unrolled& picture, int j) {
  const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(picture.width) * 4;
  return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}

TEST(Unrolled, IsARowOfTheSurfaceAPixelAndBareClayHasItsColor) {
  const surface::Surface surface = surface_of(plain());
  const Unrolled picture = unrolled(surface, plain());
  EXPECT_EQ(picture.width, surface::kSectors);
  EXPECT_EQ(picture.height, surface.rows());
  // IEC 61966-2-1: 0.5, 0.4, 0.3.
  EXPECT_EQ(color_of(picture, 100), (std::array{188, 170, 149}));
}

TEST(Unrolled, AThickCoatHidesTheClayAndAThinOneLetsItThrough) {
  Decoration decoration = plain();
  Step thick, thin;
  thick.to = 0.3, thick.thickness = 8e-4;
  thin.from = 0.5, thin.to = 0.8, thin.thickness = 2e-5, thin.pigment = 1;
  decoration.steps = {thick, thin};
  const surface::Surface surface = surface_of(decoration);
  const Unrolled picture = unrolled(surface, decoration);
  const int lip = lip_of(surface) / surface::kRowHeight;
  EXPECT_NEAR(color_of(picture, lip / 5)[0], 243, 1);  // of 0.9
  // 1 - exp(-20/50): a third of the blue, two thirds of the clay.
  const auto through = color_of(picture, lip * 2 / 3);
  const double share = 1.0 - std::exp(-0.4), light = 0.5 * (1.0 - share);
  EXPECT_NEAR(through[0], 255.0 * (1.055 * std::pow(light, 1.0 / 2.4) - 0.055), 3);
}

TEST(Unrolled, WhatWasLaidLastLiesOnTop) {
  Decoration decoration = plain();
  Step blue, white;
  blue.pigment = 1, blue.thickness = 8e-4;
  white.from = 0.4, white.thickness = 8e-4;
  decoration.steps = {blue, white};
  const surface::Surface surface = surface_of(decoration);
  const Unrolled picture = unrolled(surface, decoration);
  const int lip = lip_of(surface) / surface::kRowHeight;
  EXPECT_NEAR(color_of(picture, lip / 5)[0], 0, 1);
  EXPECT_NEAR(color_of(picture, lip * 2 / 3)[0], 243, 1);
}

TEST(Unrolled, GlazeIsDarkerWhereItIsDeep) {
  Decoration decoration = plain();
  Step cut, glaze;
  cut.kind = Step::cut, cut.width = 0.004, cut.depth = 0.001, cut.size = 0.02;
  cut.motif.lines = {{{-1.0, 0.0}, {1.0, 0.0}}};
  glaze.pigment = kGlaze, glaze.thickness = 4e-4;
  decoration.steps = {cut, glaze};
  const surface::Surface surface = surface_of(decoration);
  const Unrolled picture = unrolled(surface, decoration);
  const int middle = lip_of(surface) / 2 / surface::kRowHeight;
  const auto shallow = color_of(picture, middle + 60), deep = color_of(picture, middle);
  EXPECT_NEAR(shallow[1], 255.0 * (1.055 * std::pow(0.4 * 0.8, 1.0 / 2.4) - 0.055), 2);
  EXPECT_LT(deep[0], shallow[0] - 20);
}

// A triangle that goes back over the whole picture shows all of it, squeezed.
TEST(Unrolled, NoTriangleGoesBackOverThePicture) {
  const surface::Surface surface = surface_of(plain());
  const TriangleMesh mesh = revolve(beaker(), 96);
  const Skin skin = placed(mesh, beaker(), surface);
  ASSERT_EQ(skin.places.size(), skin.mesh.positions.size());
  ASSERT_EQ(skin.mesh.normals.size(), skin.mesh.positions.size());
  ASSERT_EQ(skin.mesh.triangles.size(), mesh.triangles.size());
  const double lip = static_cast<double>(lip_of(surface)) / (surface.rows() * surface::kRowHeight);
  for (const auto& triangle : skin.mesh.triangles)
    for (const std::uint32_t i : triangle) {
      const auto &p = skin.mesh.positions[i], &q = skin.mesh.positions[triangle[0]];
      const bool axis = std::hypot(p[0], p[2]) < 1e-6 || std::hypot(q[0], q[2]) < 1e-6;
      if (!axis) {
        EXPECT_NEAR(skin.places[i][0], skin.places[triangle[0]][0], 1.5 / 96);
      }
    }
  for (std::size_t i = 0; i < skin.places.size(); ++i) {
    const auto& p = skin.mesh.positions[i];
    const double radius = std::hypot(p[0], p[2]);
    if (p[1] == 0.0f) {
      EXPECT_EQ(skin.places[i][1], 0.0f);
    } else if (p[1] > 0.149f) {
      EXPECT_NEAR(skin.places[i][1], lip, 0.02);
    } else if (p[1] < 0.011f && radius < 0.001) {
      EXPECT_EQ(skin.places[i][1], 1.0f);
    }
  }
}

}  // namespace
}  // namespace onggi::decoration::unrolled_test

#include "kiosk/exhibit/composition/lean_pot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "engine/clay/clay.h"

namespace onggi::exhibit {
namespace {

using Point = std::array<float, 3>;

/// A jar whose wall at a height and an angle is at `outer(height, angle)`, 6 mm thick.
template <class Outer>
ClayMesh jar(int rows, int sectors, Outer outer) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.height = 0.2;
  ClayView clay;
  clay.lay(def);
  for (int row = 0; row < rows; ++row) {
    std::vector<float> out, in;
    for (int k = 0; k < sectors; ++k) {
      const double r = outer(clay.row_height(row), 2 * std::numbers::pi * k / sectors);
      out.push_back(static_cast<float>(r));
      in.push_back(row < clay.floor_rows() ? 0.0f : static_cast<float>(r - 0.006));
    }
    clay.shape(row, out, in);
  }
  return faced_mesh_of(clay);
}

std::vector<view::SkinPoint> skin_of(const ClayMesh& pot, float band_at = -1) {
  std::vector<view::SkinPoint> skin;
  for (const Point& p : pot.mesh.positions) {
    const bool band = band_at >= 0 && std::abs(p[1] - band_at) < 0.002f;
    skin.push_back({{0.4f, band ? 0.1f : 0.3f, 0.2f}, 0.3f});
  }
  return skin;
}

double belly(double height, double) { return 0.06 + 0.02 * std::sin(16 * height); }

/// Each edge has one neighbour that runs the other way: no slit, no flap.
void expect_closed(const TriangleMesh& mesh) {
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

double volume(const TriangleMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t k, std::size_t axis) {
      return static_cast<double>(mesh.positions[t[k]][axis]);
    };
    for (std::size_t k = 0; k < 3; ++k)
      six += at(0, k) *
             (at(1, (k + 1) % 3) * at(2, (k + 2) % 3) - at(1, (k + 2) % 3) * at(2, (k + 1) % 3));
  }
  return six / 6;
}

/// The greatest distance of `whole`'s positions from their neighbours in `some`, along the height.
double silhouette(const TriangleMesh& some, double height) {
  // Radius at a height, of the outer wall at angle 0: positions with z = 0 and x > 0.
  double below_y = -1, below_r = 0, above_y = 1, above_r = 0;
  for (const Point& p : some.positions) {
    if (p[0] < 0.035f || std::abs(p[2]) > 1e-6f) continue;
    const auto y = static_cast<double>(p[1]), r = static_cast<double>(p[0]);
    if (y <= height && (y > below_y || (y == below_y && r > below_r))) below_y = y, below_r = r;
    if (y >= height && (y < above_y || (y == above_y && r > above_r))) above_y = y, above_r = r;
  }
  return below_r + (above_r - below_r) * (height - below_y) / std::max(above_y - below_y, 1e-9);
}

TEST(LeanPot, ASmoothJarHasAFewOfItsTrianglesAndIsStillClosedAndAsLarge) {
  const ClayMesh whole = jar(256, 180, belly);
  const LeanPot pot = lean(whole, skin_of(whole));
  EXPECT_LT(pot.mesh.triangles.size(), whole.mesh.triangles.size() / 8);
  EXPECT_EQ(pot.mesh.positions.size(), pot.skin.size());
  EXPECT_EQ(pot.mesh.positions.size(), pot.mesh.normals.size());
  expect_closed(whole.mesh);
  expect_closed(pot.mesh);
  EXPECT_NEAR(volume(pot.mesh) / volume(whole.mesh), 1.0, 2e-3);
  for (double height = 0.01; height < 0.18; height += 0.0037)
    EXPECT_NEAR(silhouette(pot.mesh, height), silhouette(whole.mesh, height), 1e-4) << height;
}

TEST(LeanPot, WhatAHandLeftStays) {
  const auto dented = [](double height, double angle) {
    const double off = std::hypot(0.06 * (angle - 2), height - 0.1);
    return belly(height, 0) - 0.004 * std::exp(-off * off / 0.00005);
  };
  const auto ribbed = [](double height, double) {
    return belly(height, 0) + 0.0004 * std::sin(2 * std::numbers::pi * height / 0.004);
  };
  const ClayMesh smooth = jar(256, 180, belly);
  const std::size_t least = lean(smooth, skin_of(smooth)).mesh.triangles.size();
  for (const ClayMesh& whole : {jar(256, 180, dented), jar(256, 180, ribbed)}) {
    const LeanPot pot = lean(whole, skin_of(whole));
    EXPECT_GT(pot.mesh.triangles.size(), 2 * least);
    expect_closed(pot.mesh);
    EXPECT_NEAR(volume(pot.mesh) / volume(whole.mesh), 1.0, 2e-3);
  }
}

TEST(LeanPot, APaintedBandKeepsItsEdges) {
  const ClayMesh whole = jar(256, 180, belly);
  const LeanPot pot = lean(whole, skin_of(whole, 0.1f));
  std::map<float, float> green;  // by height
  for (std::size_t n = 0; n < pot.skin.size(); ++n)
    green[pot.mesh.positions[n][1]] = pot.skin[n].color[1];
  const auto at = [&](float height) { return std::prev(green.upper_bound(height)); };
  EXPECT_EQ(at(0.1f)->second, 0.1f);
  EXPECT_NEAR(at(0.098f)->first, 0.098f, 0.0016f) << "rows are 0.8 mm apart";
  EXPECT_EQ(at(0.0975f)->second, 0.3f);
  EXPECT_EQ(at(0.1035f)->second, 0.3f);
}

TEST(LeanPot, IsTheSameEachTime) {
  const ClayMesh whole = jar(64, 96, belly);
  const LeanPot a = lean(whole, skin_of(whole)), b = lean(whole, skin_of(whole));
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

}  // namespace
}  // namespace onggi::exhibit

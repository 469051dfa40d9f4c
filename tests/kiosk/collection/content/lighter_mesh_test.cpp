#include "kiosk/collection/content/lighter_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace onggi::content::lighter_mesh_test {
namespace {

/// A straight pot of 10 cm, a corner for every triangle where `loose`.
TriangleMesh a_pot(int sectors, bool loose = false) {
  Section wall;
  wall.outline = {{0, 0}, {0.05, 0}};
  for (int i = 1; i <= 60; ++i) wall.outline.push_back({0.05, 0.1 * i / 60});
  wall.outline.push_back({0, 0.1});
  const TriangleMesh mesh = revolve(wall, sectors);
  if (!loose) return mesh;
  TriangleMesh out;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (const std::uint32_t corner : triangle) out.positions.push_back(mesh.positions[corner]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// The farthest that a triangle's middle is from the pot's wall, foot or top, m.
double farthest(const TriangleMesh& mesh, const LighterMesh& light) {
  double worst = 0;
  for (const auto& t : light.triangles) {
    double x = 0, y = 0, z = 0;
    for (const std::uint32_t corner : t) {
      x += static_cast<double>(mesh.positions[corner][0]) / 3;
      y += static_cast<double>(mesh.positions[corner][1]) / 3;
      z += static_cast<double>(mesh.positions[corner][2]) / 3;
    }
    worst = std::max(worst, std::min({std::abs(0.05 - std::hypot(x, z)), y, 0.1 - y}));
  }
  return worst;
}

TEST(LighterMesh, AMeshOfFewTrianglesStaysAsItIs) {
  EXPECT_TRUE(lighter(a_pot(60)).triangles.empty());
}

TEST(LighterMesh, AFineScanIsThinnedToWhatIsAskedAndKeepsItsShape) {
  const TriangleMesh scan = a_pot(720);
  ASSERT_GT(scan.triangles.size(), 3 * kTurningTriangles);
  const LighterMesh light = lighter(scan);
  EXPECT_FALSE(light.coarse);
  EXPECT_LE(light.triangles.size(), kTurningTriangles);
  EXPECT_GT(light.triangles.size(), 200u);
  EXPECT_LT(farthest(scan, light), 0.0003);
}

TEST(LighterMesh, WhatIsNothingButLooseTrianglesIsThinnedCoarsely) {
  const TriangleMesh scan = a_pot(720, true);
  const LighterMesh light = lighter(scan, 4000);
  EXPECT_TRUE(light.coarse);
  EXPECT_LE(light.triangles.size(), 4000u);
  EXPECT_GT(light.triangles.size(), 200u);
  EXPECT_LT(farthest(scan, light), 0.005);
}

TEST(LighterMesh, TheSameMeshGivesTheSameTriangles) {
  EXPECT_EQ(lighter(a_pot(720)).triangles, lighter(a_pot(720)).triangles);
}

}  // namespace
}  // namespace onggi::content::lighter_mesh_test

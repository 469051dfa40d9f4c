#include "engine/clay/clay_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/clay/lip.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::clay_mesh_test {
namespace {

Clay lump(const ClayDef& def) { return std::move(*Clay::create(def)); }

ClayView seen(const Clay& clay) {
  ClayView view;
  view.take(clay);
  return view;
}

// Vertices of the five faces lie doubled on the edges between them.
TriangleMesh joined(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::vector<std::uint32_t> place(mesh.positions.size());
  for (std::size_t n = 0; n < mesh.positions.size(); ++n) {
    const auto same = std::ranges::find(out.positions, mesh.positions[n]);
    place[n] = static_cast<std::uint32_t>(same - out.positions.begin());
    if (same == out.positions.end()) out.positions.push_back(mesh.positions[n]);
  }
  for (auto t : mesh.triangles) {
    for (std::uint32_t& corner : t) corner = place[corner];
    out.triangles.push_back(t);
  }
  return out;
}

double top_of(const TriangleMesh& mesh) {
  float top = 0.0f;
  for (const auto& p : mesh.positions) top = std::max(top, p[1]);
  return double{top};
}

TEST(ClayMesh, IsClosedRoundLippedAndAsTallAsThePot) {
  ClayDef def;
  def.rows = 60;
  def.sectors = 48;
  for (const double inner : {0.022, 0.049}) {
    def.inner_radius = inner;
    const Clay clay = lump(def);
    const TriangleMesh mesh = mesh_of(seen(clay));
    EXPECT_EQ(shapes::open_edges(joined(mesh)), 0);
    EXPECT_NEAR(top_of(mesh), 0.2, 1e-6);
    // The edges are rounded off, and a polygon of 48 corners is short of the circle.
    EXPECT_LT(shapes::volume(mesh), clay.volume());
    EXPECT_NEAR(shapes::volume(mesh) / clay.volume(), 1.0, 0.01);
  }
}

TEST(ClayMesh, IsAsRoundWhateverTheNumberOfSectorsDividesInto) {
  ClayDef def;
  def.rows = 8;
  for (const int sectors : {181, 362, 367, 8191}) {
    def.sectors = sectors;
    const Clay clay = lump(def);
    const TriangleMesh mesh = mesh_of(seen(clay));
    EXPECT_EQ(shapes::open_edges(joined(mesh)), 0) << sectors;
    EXPECT_NEAR(shapes::volume(mesh) / clay.volume(), 1.0, 0.01) << sectors;
    EXPECT_LT(mesh.triangles.size(), 20000u) << sectors;
  }
}

TEST(ClayMesh, TheLipOfAWallThatLeansStandsOnTheWallItself) {
  ClayDef def;
  def.rows = 200;
  def.sectors = 48;
  def.inner_radius = 0.03;
  for (const double slope : {-0.6, 0.6}) {
    Clay clay = lump(def);
    const double top = clay.rim_height();
    const auto outer = [&](double y) { return 0.06 + slope * (y - top); };
    for (int j = clay.rows() / 2; j < clay.rows(); ++j) {
      const auto radius = static_cast<float>(outer(clay.row_height(j)));
      std::ranges::fill(clay.outer_mut(j), radius);
      std::ranges::fill(clay.inner_mut(j), radius - 0.012f);
      clay.mark_dirty(j);
    }
    const ClayMesh mesh = faced_mesh_of(seen(clay));
    EXPECT_EQ(shapes::open_edges(joined(mesh.mesh)), 0);
    double farthest = 0.0;
    for (std::size_t n = 0; n < mesh.faces.size(); ++n) {
      if (mesh.faces[n] != ClayFace::outer && mesh.faces[n] != ClayFace::inner) continue;
      const auto& p = mesh.mesh.positions[n];
      if (double{p[1]} < top - 0.01) continue;
      const double wall = outer(double{p[1]}) - (mesh.faces[n] == ClayFace::inner ? 0.012 : 0.0);
      farthest = std::max(farthest, std::abs(std::hypot(double{p[0]}, double{p[2]}) - wall));
    }
    EXPECT_LT(farthest, 1e-5);
  }
}

TEST(ClayMesh, ALumpThatNobodyOpenedIsClosedAndFlatInItsMiddle) {
  ClayDef def;
  def.rows = 60;
  def.sectors = 48;
  def.floor_thickness = def.height;
  const Clay clay = lump(def);
  const TriangleMesh mesh = mesh_of(seen(clay));
  EXPECT_EQ(shapes::open_edges(joined(mesh)), 0);
  EXPECT_NEAR(shapes::volume(mesh) / clay.volume(), 1.0, 0.01);
  for (const auto& p : mesh.positions)
    EXPECT_TRUE(std::hypot(p[0], p[2]) > 0.01f || p[1] == 0.0f || p[1] > 0.1999f);
}

TEST(ClayMesh, FollowsRowsPressedTogetherAndAFloorThatSank) {
  ClayDef def;
  def.rows = 60;
  def.sectors = 48;
  Clay clay = lump(def);
  for (int j = 40; j < 60; ++j) clay.set_row_thickness(j, 0.001);
  clay.restack(40);
  clay.lower_floor(0.0095);
  const TriangleMesh mesh = mesh_of(seen(clay));
  EXPECT_EQ(shapes::open_edges(joined(mesh)), 0);
  EXPECT_NEAR(top_of(mesh), clay.rim_height(), 1e-6);
  bool floor = false;
  for (const auto& p : mesh.positions) floor = floor || p[1] == 0.0095f;
  EXPECT_TRUE(floor);
}

}  // namespace
}  // namespace onggi::clay_mesh_test

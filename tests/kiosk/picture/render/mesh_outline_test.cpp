#include "kiosk/picture/render/mesh_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/kiosk/picture/render/edges_fixture.h"

namespace onggi::render::testing::mesh_outline_test {
namespace {

double shelf_belly(double t) { return 0.035 + 0.035 * std::sin(0.3 + 2.6 * t); }
double shelf_foot(double t) { return 0.05 + 0.02 * t; }

/// A hollow vessel of that outline, `high` metres, 5 mm thick.
TriangleMesh turned_vessel(double (*outer)(double), double high, int sectors = 120) {
  Section s;
  s.outline = {{0, 0}};
  for (int i = 0; i <= 60; ++i) s.outline.push_back({outer(i / 60.0), high * i / 60});
  for (int i = 60; i >= 4; --i) s.outline.push_back({outer(i / 60.0) - 0.005, high * i / 60});
  s.outline.push_back({0, high * 4 / 60});
  return revolve(s, sectors);
}

/// Adds a handle at +x or -x: a round bar of 6 mm bent into half a circle.
void add_handle(TriangleMesh& mesh, float side) {
  constexpr std::uint32_t kBend = 40, kAround = 14;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i <= kBend; ++i)
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const float a = std::numbers::pi_v<float> * (static_cast<float>(i) / kBend - 0.5f),
                  b = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / kAround;
      const float r = 0.03f + 0.006f * std::cos(b);
      mesh.positions.push_back(
          {side * (0.062f + r * std::cos(a)), 0.125f + r * std::sin(a), 0.006f * std::sin(b)});
    }
  for (std::uint32_t i = 0; i < kBend; ++i)
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const std::uint32_t a = first + i * kAround + k, b = first + i * kAround + (k + 1) % kAround;
      mesh.triangles.push_back({a, b, a + kAround});
      mesh.triangles.push_back({b, b + kAround, a + kAround});
    }
  mesh.normals.clear();
}

class AVesselsEdge : public AnEdge {
 protected:
  /// A jar at the right, and `mesh` at the left with nothing of the pot in the way.
  view::Frame beside(const TriangleMesh& mesh, double angle, double tilt = 0.0) {
    view::Frame frame = show(grid_of(120, 120, 0.16, 0.010), shelf_foot, 0.16, 0.09);
    put(mesh);
    view::PotView& pot = *frame.pot;
    pot.wheel = false;
    pot.camera = view::frame_pot(kWide, kTall, {250, 60, 220, 270}, 0.18, 0.10);
    pot.camera.elevation += tilt;
    pot.beside = view::VesselView{pot.camera, angle};
    pot.beside->camera.centre_x -= 240;
    part_ = [](int x, int) { return x < 238; };
    return frame;
  }
  static void put(const TriangleMesh& mesh) {
    stage_->show_vessel(model_of(mesh, {0.45f, 0.26f, 0.16f}, {}, 1.0f), edges_of(mesh, 1.0f));
  }
};

TEST_F(AVesselsEdge, OfARoundVesselIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  expect_smooth(beside(turned_vessel(shelf_belly, 0.18), 0.3), "vessel_round",
                {{{0.4, 0.0005}, {0.26, 0.0005}}});
}

TEST_F(AVesselsEdge, OfHandlesIsSmoothFromEachSide) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  TriangleMesh mesh = turned_vessel(shelf_belly, 0.18);
  for (const float side : {-1.0f, 1.0f}) add_handle(mesh, side);
  for (const double angle : {0.0, 0.5, 1.1})
    expect_smooth(beside(mesh, angle), "vessel_handles_" + std::to_string(std::lround(10 * angle)),
                  {{{0.42, 0.0005}, {0.33, 0.002}}});
}

TEST_F(AVesselsEdge, OfAnOvalBowlFromAboveIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  TriangleMesh mesh = turned_vessel(shelf_foot, 0.09);
  for (auto& p : mesh.positions) p = {1.3f * p[0], p[1] * (1.0f + 2.0f * p[0]), 0.8f * p[2]};
  mesh.normals.clear();
  for (const double tilt : {0.0, 0.4})
    expect_smooth(beside(mesh, 0.7, tilt), "vessel_oval_" + std::to_string(std::lround(10 * tilt)),
                  {{{0.58, 0.001}, {0.39, 0.0035}}});
}

TEST_F(AVesselsEdge, IsSmoothWhereTheFrameCutsTheVesselOff) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  TriangleMesh mesh = turned_vessel(shelf_belly, 0.18);
  add_handle(mesh, 1.0f);
  view::Frame frame = beside(mesh, 0.2);
  frame.pot->beside->camera.centre_x = 20;
  frame.pot->beside->camera.centre_y += 120;
  expect_smooth(frame, "vessel_cut_off", {{{0.34, 0.0005}, {0.24, 0.001}}});
}

TEST_F(AVesselsEdge, IsSmoothBehindAndBeforeThePot) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  view::Frame frame = beside(turned_vessel(shelf_belly, 0.18), 0.0);
  for (const float aside : {70.0f, 110.0f}) {
    frame.pot->beside->camera.centre_x = frame.pot->camera.centre_x - aside;
    part_ = {};
    expect_smooth(frame, "vessel_overlapped_" + std::to_string(std::lround(aside)),
                  {{{0.5, 0.0005}, {0.36, 0.004}}});
  }
}

TEST_F(AVesselsEdge, IsTheNewVesselsAfterAChangeAndNoneWithoutOne) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  view::Frame frame = beside(turned_vessel(shelf_belly, 0.18), 0.0);
  drawn(frame, 0.5);
  put(turned_vessel(shelf_foot, 0.12));
  expect_smooth(frame, "vessel_changed", {{{0.53, 0.0005}, {0.4, 0.002}}});
  frame.pot->beside.reset();
  const view::Image with = drawn(frame, 0.5), without = laid(frame, 0.5);
  for (int y = 0; y < kTall; ++y)
    for (int x = 0; x < 240; ++x) {
      const Pixel a = pixel_at(with, x, y), b = pixel_at(without, x, y);
      ASSERT_TRUE(a.r == b.r && a.g == b.g && a.b == b.b) << x << " " << y;
    }
}

/// Each triangle with corners of its own. Every `flipped`th is turned inside out; 0: none.
TriangleMesh loosened(const TriangleMesh& mesh, std::size_t flipped) {
  TriangleMesh loose;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(loose.positions.size());
    for (const std::uint32_t c : t) loose.positions.push_back(mesh.positions[c]);
    const bool flip = flipped > 0 && loose.triangles.size() % flipped == 0;
    loose.triangles.push_back({first, first + (flip ? 2 : 1), first + (flip ? 1 : 2)});
  }
  return loose;
}

// A scan may be doubled at the seams of its picture, and be turned inside out.
TEST_F(AVesselsEdge, IsTheSameForLooseTrianglesAndForTheMeshInsideOut) {
  const TriangleMesh mesh = turned_vessel(shelf_belly, 0.18);
  const MeshEdges edges = edges_of(mesh, 1.0f);
  const view::VesselView seen{view::frame_pot(kWide, kTall, {20, 20, 300, 360}, 0.18, 0.09), 0.4};
  Ribbons one;
  add_mesh_outline(one, edges, seen, 2.0f);
  ASSERT_GT(one.corners.size(), 100u);
  for (const std::size_t flipped : {0u, 1u}) {
    const MeshEdges same = edges_of(loosened(mesh, flipped), 1.0f);
    EXPECT_EQ(edges.corners.size(), same.corners.size());
    EXPECT_EQ(edges.edges.size(), same.edges.size());
    Ribbons other;
    add_mesh_outline(other, same, seen, 2.0f);
    ASSERT_EQ(one.corners.size(), other.corners.size()) << flipped;
    for (std::size_t i = 0; i < one.corners.size(); ++i)
      EXPECT_LT(glm::length(one.corners[i].at - other.corners[i].at), 0.01f) << i;
  }
}

TEST_F(AVesselsEdge, OfTrianglesTurnedEitherWayIsSmooth) {
  if (renderer().status().embedded) GTEST_SKIP() << "OpenGL ES reads no depth back";
  expect_smooth(beside(loosened(turned_vessel(shelf_belly, 0.18), 5), 0.3), "vessel_either_way",
                {{{0.43, 0.001}, {0.28, 0.002}}});
}

TEST_F(AVesselsEdge, IsNoneBehindTheEye) {
  const MeshEdges edges = edges_of(turned_vessel(shelf_belly, 0.18), 1.0f);
  view::VesselView seen{view::frame_pot(kWide, kTall, {20, 20, 300, 360}, 0.18, 0.09), 0.0};
  seen.camera.distance = -0.5;
  Ribbons none;
  add_mesh_outline(none, edges, seen, 2.0f);
  EXPECT_TRUE(none.corners.empty());
}

TEST_F(AVesselsEdge, CostsFewShaderRuns) {
  if (!calls::Shading::counted()) GTEST_SKIP() << "this driver counts no shader runs";
  // As many triangles as a turning vessel has.
  TriangleMesh mesh = turned_vessel(shelf_belly, 0.18, 98);
  for (const float side : {-1.0f, 1.0f}) add_handle(mesh, side);
  ASSERT_GT(mesh.triangles.size(), 23000u);
  stage_->clay().show(thrown_clay(grid_of(240, 180, 0.18, 0.010), shelf_belly, 0.006, 0.0004));
  view::Frame frame = frame_with_pot(1920, 1080, 0.18, 0.10);
  view::PotView& pot = *frame.pot;
  pot.wheel = false;
  pot.camera = view::frame_pot(1920, 1080, {1000, 150, 700, 700}, 0.18, 0.10);
  view::Camera left = pot.camera;
  left.centre_x -= 750;
  pot.beside = view::VesselView{left, 0.0};
  for (const double scale : {0.5, 0.25}) {
    Canvas canvas;
    const Painters with{*stage_, *items_, {}};
    const auto runs = [&] {
      const FrameWork before = calls::so_far();
      {
        const calls::Shading count(true);
        canvas.paint(with, frame, {.samples = 0}, scale, Canvas::Onto::own);
        glFinish();
      }
      return static_cast<double>((calls::so_far() - before).fragment_runs);
    };
    put(mesh);
    runs();
    const double with_edges = runs();
    stage_->show_vessel(model_of(mesh, {0.45f, 0.26f, 0.16f}, {}, 1.0f), {});
    runs();
    const double without = runs();
    std::printf("scale %.2f: %.0f fragments, without the vessel's edges %.0f\n", scale, with_edges,
                without);
    EXPECT_GT(with_edges, without) << scale;
    EXPECT_LT(with_edges, (scale > 0.4 ? 1.05 : 1.1) * without) << scale;
  }
}

// The frame's own part of the work, which grows with the lines that the eye sees and not with the
// triangles behind them.
TEST_F(AVesselsEdge, IsFewLinesOfManyTriangles) {
  const view::Frame frame = beside(turned_vessel(shelf_belly, 0.18), 0.0);
  const auto corners = [&](int sectors) {
    Ribbons ribbons;
    add_mesh_outline(ribbons, edges_of(turned_vessel(shelf_belly, 0.18, sectors), 1.0f),
                     *frame.pot->beside, 2.0f);
    return static_cast<double>(ribbons.corners.size());
  };
  const double coarse = corners(60), fine = corners(480);
  EXPECT_GT(coarse, 100.0);
  EXPECT_LT(fine, 4.0 * coarse);
}

}  // namespace
}  // namespace onggi::render::testing::mesh_outline_test

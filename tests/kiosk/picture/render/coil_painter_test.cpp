#include "kiosk/picture/render/coil_painter.h"

#include <cmath>
#include <cstdlib>

#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::coil_painter_test {
namespace {

using ACoil = StudioTest;

double tube(double) { return 0.05; }

/// A low wall, and on its rim a coil over the half that faces the visitor (places 0 to 63: z > 0).
view::Frame half_a_ring(bool laid) {
  view::Frame frame = frame_with_pot(1280, 720, 0.10, 0.066);
  frame.pot->coil = {std::vector<float>(128, 0.0f), 0.013, 0.05 + 0.0065};
  for (std::size_t n = 0; laid && n < 64; ++n) frame.pot->coil.centre[n] = 0.0435f;
  return frame;
}

int unlike(const view::Image& a, const view::Image& b, Vec3 at, const view::Camera& camera) {
  const auto where = *camera.project(at);
  const Pixel p = pixel_at(a, static_cast<int>(where.first), static_cast<int>(where.second)),
              q = pixel_at(b, static_cast<int>(where.first), static_cast<int>(where.second));
  return std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
}

TEST_F(ACoil, IsDrawnWhereItLiesTurnsWithTheClayAndIsCutWithThePot) {
  Renderer& r = renderer();
  r.show_clay(thrown_clay(grid_of(100, 128, 0.05, 0.010), tube, 0.013, 0.0));
  const view::Image bare = r.draw_offscreen(half_a_ring(false));
  view::Frame frame = half_a_ring(true);
  const view::Camera camera = frame.pot->camera;
  const Vec3 front{0, 0.060, 0.047}, back{0.012, 0.060, -0.042};
  const view::Image laid = r.draw_offscreen(frame);
  keep_for_looking(laid, "coil_half_a_ring");
  EXPECT_GT(unlike(laid, bare, front, camera), 40);
  EXPECT_LT(unlike(laid, bare, back, camera), 12);
  frame.pot->clay_angle = 3.14159265;
  const view::Image turned = r.draw_offscreen(frame);
  EXPECT_LT(unlike(turned, bare, front, camera), 12);
  EXPECT_GT(unlike(turned, bare, back, camera), 40);
  frame.pot->clay_angle = 0.0;
  frame.pot->cut_away = 1.0;
  view::Frame open = half_a_ring(false);
  open.pot->cut_away = 1.0;
  const Vec3 opened{0.02, 0.060, 0.041}, left{-0.035, 0.062, 0.026};
  const view::Image cut = r.draw_offscreen(frame), bare_cut = r.draw_offscreen(open);
  keep_for_looking(cut, "coil_cut_away");
  EXPECT_LT(unlike(cut, bare_cut, opened, camera), 12) << "the front quarter is left out";
  EXPECT_GT(unlike(cut, bare_cut, left, camera), 25);
}

}  // namespace
}  // namespace onggi::render::testing::coil_painter_test

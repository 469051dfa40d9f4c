#include <cmath>

#include "tests/kiosk/picture/render/studio_fixture.h"

// The vessel that stands beside the pot.

namespace onggi::render::testing::vessel_test {
namespace {

using AVessel = StudioTest;

constexpr float kApart = 480;  // pixels

double belly(double t) { return 0.05 + 0.03 * std::sin(3.14159 * t); }

TriangleMesh mesh_like_the_pot() {
  Section s;
  s.outline = {{0, 0}};
  for (int i = 0; i <= 100; ++i) s.outline.push_back({belly(i / 100.0), 0.18 * i / 100});
  for (int i = 100; i >= 10; --i) s.outline.push_back({belly(i / 100.0) - 0.006, 0.18 * i / 100});
  s.outline.push_back({0, 0.018});
  return revolve(s, 160);
}

view::Frame both(double angle = 0) {
  view::Frame frame;
  frame.width = 1280;
  frame.height = 720;
  view::PotView pot;
  pot.camera = view::frame_pot(1280, 720, {700, 120, 400, 480}, 0.18, 0.09);
  pot.wheel = false;
  view::Camera other = pot.camera;
  other.centre_x -= kApart;
  pot.beside = view::VesselView{other, angle};
  frame.pot = pot;
  return frame;
}

void show_both(Renderer& r, double size = 1.0) {
  r.show_clay(thrown_clay(grid_of(200, 160, 0.18, 0.018), belly, 0.006, 0));
  r.show_vessel(mesh_like_the_pot(), {0.62f, 0.44f, 0.31f}, {}, size);
}

double brightness(const view::Image& image, int x, int y) {
  const Pixel p = pixel_at(image, x, y);
  return 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b;
}

/// From the left inwards: where the row changes by so much that an outline must be there.
int left_edge(const view::Image& image, const view::Camera& camera, double height) {
  const auto [cx, cy] = *camera.project({0, height, 0});
  const int y = static_cast<int>(cy), middle = static_cast<int>(cx);
  int x = middle - 210;
  while (std::abs(brightness(image, x + 2, y) - brightness(image, x, y)) < 12 && x < middle) ++x;
  return x;
}

TEST_F(AVessel, IsAsLargeAsAPotOfItsShapeAndStandsOnTheSameGround) {
  Renderer& r = renderer();
  show_both(r);
  const view::Frame frame = both();
  const view::Image image = r.draw_offscreen(frame);
  keep_for_looking(image, "vessel_beside_pot");
  for (const double h : {0.05, 0.09, 0.14}) {
    const int pot = left_edge(image, frame.pot->camera, h);
    const int vessel = left_edge(image, frame.pot->beside->camera, h);
    EXPECT_NEAR(vessel + static_cast<int>(kApart), pot, 2) << h;
    EXPECT_NEAR(pot, frame.pot->camera.project({-belly(h / 0.18), h, 0})->first, 7) << h;
  }
}

TEST_F(AVessel, TheSameLightFallsOnBoth) {
  Renderer& r = renderer();
  show_both(r);
  const view::Frame frame = both();
  const view::Image image = r.draw_offscreen(frame);
  const auto light = [&](const view::Camera& camera, double x) {
    const auto at = *camera.project({x, 0.1, std::sqrt(0.0784 * 0.0784 - x * x)});
    double sum = 0;
    for (int dx = -6; dx <= 6; ++dx)
      sum += brightness(image, static_cast<int>(at.first) + dx, static_cast<int>(at.second));
    return sum / 13;
  };
  // Brighter towards the window, and by as much.
  const auto falls = [&](const view::Camera& c) { return light(c, -0.045) / light(c, 0.055); };
  const double pot = falls(frame.pot->camera), vessel = falls(frame.pot->beside->camera);
  EXPECT_GT(pot, 1.3);
  EXPECT_NEAR(vessel / pot, 1.0, 0.25);
}

TEST_F(AVessel, TurnsAboutItsAxisAsThePotDoes) {
  Renderer& r = renderer();
  show_both(r);
  // A handle at the right, at -x after half a turn; towards the eye (+z) after a quarter.
  TriangleMesh mesh = mesh_like_the_pot();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& p :
       {std::array<float, 3>{0.07f, 0.08f, 0}, {0.07f, 0.11f, 0}, {0.12f, 0.095f, 0}})
    mesh.positions.push_back(p), mesh.normals.push_back({0, 0, 1});
  mesh.triangles.push_back({first, first + 2, first + 1});
  r.show_vessel(mesh, {0.05f, 0.05f, 0.05f}, {}, 1.0);
  const auto dark_at = [&](double angle, double x) {
    const view::Frame frame = both(angle);
    const auto at = *frame.pot->beside->camera.project({x, 0.095, 0});
    return brightness(r.draw_offscreen(frame), static_cast<int>(at.first),
                      static_cast<int>(at.second)) < 110;
  };
  EXPECT_TRUE(dark_at(0, 0.095));
  EXPECT_FALSE(dark_at(0, -0.095));
  EXPECT_TRUE(dark_at(3.14159, -0.095));
  EXPECT_FALSE(dark_at(1.5708, 0.095));
  // As the clay's angles are meant: a quarter brings what was at the right to the front.
  view::Frame frame = both(0.9);
  const auto at =
      *frame.pot->beside->camera.project({0.105 * std::cos(0.9), 0.095, 0.105 * std::sin(0.9)});
  EXPECT_LT(
      brightness(r.draw_offscreen(frame), static_cast<int>(at.first), static_cast<int>(at.second)),
      110);
}

TEST_F(AVessel, ThePotAloneIsThePictureThatItWas) {
  Renderer& r = renderer();
  show_both(r);
  view::Frame frame = both();
  frame.pot->beside.reset();
  const view::Image alone = r.draw_offscreen(frame);
  const view::Image two = r.draw_offscreen(both());
  EXPECT_EQ(r.draw_offscreen(frame).rgba, alone.rgba);
  // To the pot itself nothing is added.
  const auto [x, y] = *frame.pot->camera.project({0, 0.1, 0.07});
  for (int dx = -100; dx <= 100; dx += 4) {
    const Pixel a = pixel_at(alone, static_cast<int>(x) + dx, static_cast<int>(y));
    const Pixel b = pixel_at(two, static_cast<int>(x) + dx, static_cast<int>(y));
    EXPECT_EQ(a.r, b.r);
    EXPECT_EQ(a.b, b.b);
  }
}

}  // namespace
}  // namespace onggi::render::testing::vessel_test

#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "kiosk/picture/render/renderer.h"

namespace onggi::render::testing {

/// One hidden window for all tests of this program, on the display there is or on an Xvfb of its
/// own. Skips by name where there is neither.
class StudioTest : public ::testing::Test {
 protected:
  void SetUp() override;
  static Renderer& renderer();
  static constexpr int kWidth = 1280, kHeight = 720;
};

/// A grid of even rows over `height`, with a floor; metres.
ClayDef grid_of(int rows, int sectors, double height, double floor);

/// A jar whose outer radius follows `outer(t)` (t = 0 foot .. 1 rim, metres), `wall` thick, with
/// throwing lines `grooves` deep.
ClayView thrown_clay(const ClayDef& grid, double (*outer)(double), double wall, double grooves);

/// Rows from..to - 1 tear, or heal.
void tear(ClayView& clay, int from, int to, bool torn = true);

/// Writes `image` as NAME.ppm into $ONGGI_GALLERY where that is set, for people to look at. Where
/// $ONGGI_ALIKE names such a folder of another driver's or another OpenGL's, the picture there must
/// look the same.
void keep_for_looking(const view::Image& image, const std::string& name);

/// A pot in the middle of a frame of this size, dry, closed.
view::Frame frame_with_pot(int width, int height, double pot_height, double pot_radius);

struct Pixel {
  int r = 0, g = 0, b = 0;
};
Pixel pixel_at(const view::Image& image, int x, int y);

}  // namespace onggi::render::testing

#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kiosk/picture/render/canvas.h"
#include "kiosk/picture/render/items.h"
#include "kiosk/picture/render/stage.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing {

/// Draws a frame at any scale with one sample a pixel, as a machine without a GPU does, and says
/// how far it is from a picture with many samples.
class AnEdge : public StudioTest {
 protected:
  static constexpr int kWide = 480, kTall = 400;

  void SetUp() override;
  static void TearDownTestSuite();
  /// A frame with that pot alone.
  view::Frame show(const ClayDef& grid, double (*outer)(double), double height, double radius);
  view::Image drawn(const view::Frame& frame, double scale);
  /// The same without its edges, or with those that no finger's depth hides: the picture as it is
  /// laid over the ground. `metres`, if it is asked for: how far each pixel of the picture is from
  /// the eye, from the lower left.
  view::Image laid(const view::Frame& frame, double scale, std::vector<float>* metres = nullptr,
                   bool edges = false);
  /// Draws the frame with 8 x 8 samples a pixel, and finds the pixels near its edges, by the steps
  /// in depth.
  void sample(view::Frame frame, const std::string& name);
  static std::size_t pixel(int x, int y) { return static_cast<std::size_t>(y * kWide + x); }
  /// Mean difference from the samples near the edges, of 255.
  double difference(const view::Image& image) const;
  /// Share of the pixels near the edges that are brighter or darker by 16 of 255 than all samples
  /// within two pixels: a halo, a seam or a hole.
  double odd(const view::Image& image) const;
  struct Most {
    double error = 0, odd = 0;
  };
  /// At scales 0.5 and 0.25: the error's share of that without edges, and the odd pixels.
  void expect_smooth(const view::Frame& frame, const std::string& name, std::array<Most, 2> most);

  static std::unique_ptr<Stage> stage_;
  static std::unique_ptr<ItemPainter> items_;
  ClayView clay_;
  std::vector<bool> near_;
  std::vector<double> reference_;
  std::function<bool(int, int)> only_;  ///< The pixels to look at; none: those near an edge.
  std::function<bool(int, int)> part_;  ///< Of those; none: all.

 private:
  void mark(int x, int y);
};

}  // namespace onggi::render::testing

#include "kiosk/exhibit/composition/small_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace onggi::exhibit {

namespace {

constexpr double kPi = 3.14159265358979;
/// The shadow is whole up to the first share of the way from the foot to the picture's edge, and
/// gone at the second.
constexpr double kWhole = 0.3, kGone = 0.95;

/// A pot's part of each line of a picture.
struct Span {
  double from = std::numeric_limits<double>::max(), to = std::numeric_limits<double>::lowest();
};

std::vector<Span> spans_of(const view::Camera& camera, const Profile& made, int lines) {
  constexpr int kHeights = 400, kAroundPot = 96;
  std::vector<Span> spans(static_cast<std::size_t>(lines));
  for (int j = 0; j <= kHeights; ++j)
    for (int i = 0; i < kAroundPot; ++i) {
      const double y = made.height() * j / kHeights, angle = 2 * kPi * i / kAroundPot;
      const double r = made.outer_at(y);
      const auto at = camera.project({r * std::cos(angle), y, r * std::sin(angle)});
      if (!at) continue;
      // A corner belongs to the lines that it touches.
      for (const double line : {std::floor(at->second - 0.5), std::floor(at->second + 0.5)}) {
        if (line < 0 || line >= lines) continue;
        Span& span = spans[static_cast<std::size_t>(line)];
        span.from = std::min(span.from, static_cast<double>(at->first));
        span.to = std::max(span.to, static_cast<double>(at->first));
      }
    }
  return spans;
}

}  // namespace

view::Frame small_picture(const Profile& made, const std::optional<view::Glazing>& glazing) {
  constexpr int kWidth = 240, kHeight = 300;
  view::Frame frame;
  frame.width = kWidth;
  frame.height = kHeight;
  view::PotView pot;
  pot.camera =
      view::frame_pot(kWidth, kHeight, {24, 24, 192, 236}, made.height(), made.max_radius());
  pot.wheel = false;
  if (glazing) {
    pot.finish = view::Finish::fired;
    pot.glazing = *glazing;
  }
  frame.pot = pot;
  return frame;
}

view::Frame without_pot(view::Frame picture) {
  picture.pot.reset();
  return picture;
}

view::Image with_soft_shadow(view::Image picture, const view::Image& plaster,
                             const view::Camera& camera, const Profile& made) {
  const auto foot = camera.project({0, 0, 0});
  if (!foot || plaster.rgba.size() != picture.rgba.size()) return picture;
  const double left = foot->first, above = foot->second;
  const std::vector<Span> spans = spans_of(camera, made, picture.height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      // The share of the way from the foot to the edge.
      const double dx = x + 0.5 - left, dy = y + 0.5 - above;
      const double across = dx / (dx > 0 ? picture.width - left : left);
      const double down = dy / (dy > 0 ? picture.height - above : above);
      const double t = std::clamp((std::hypot(across, down) - kWhole) / (kGone - kWhole), 0.0, 1.0);
      const Span& span = spans[static_cast<std::size_t>(y)];
      const double inside = std::clamp(std::min(x + 1.0 - span.from, span.to - x), 0.0,
                                       1.0);  // of the pixel, the pot's
      const double stays = std::max(1 - t * t * (3 - 2 * t), inside);
      const std::size_t at =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(x));
      for (std::size_t k = at; k < at + 3; ++k)
        picture.rgba[k] = static_cast<std::uint8_t>(
            std::lround(plaster.rgba[k] + stays * (picture.rgba[k] - plaster.rgba[k])));
    }
  return picture;
}

}  // namespace onggi::exhibit

#include "kiosk/lab/measure/drawn_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "kiosk/collection/textures/srgb.h"

namespace onggi::measure {

namespace {

constexpr int kDrawnDiffers = 12;  // of 255, all channels: smaller differences are dither
constexpr double kFlashStep = 0.1, kFlashDark = 0.8;

double linear(std::uint8_t v) { return textures::light_of_srgb(v / 255.0); }

}  // namespace

double luminance(const std::uint8_t* rgba) {
  return 0.2126 * linear(rgba[0]) + 0.7152 * linear(rgba[1]) + 0.0722 * linear(rgba[2]);
}

double contrast(const std::uint8_t* one, const std::uint8_t* other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

double drawn_contrast(const view::Image& with, const view::Image& without, const view::Rect& box) {
  const int x0 = std::clamp(static_cast<int>(box.x), 0, with.width);
  const int x1 = std::clamp(static_cast<int>(box.x + box.w + 1), 0, with.width);
  const int y0 = std::clamp(static_cast<int>(box.y), 0, with.height);
  const int y1 = std::clamp(static_cast<int>(box.y + box.h + 1), 0, with.height);
  std::vector<double> all;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(with.width) +
                           static_cast<std::size_t>(x));
      const std::uint8_t *a = &with.rgba[at], *b = &without.rgba[at];
      const int apart = std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
      if (apart > kDrawnDiffers) all.push_back(contrast(a, b));
    }
  if (all.empty()) return 0;
  std::sort(all.begin(), all.end(), std::greater<>());
  return all[all.size() / 20];  // the middle of that tenth
}

void FlashCount::see(const view::Image& picture, double now) {
  const int across = std::max(1, picture.width / cell_), down = std::max(1, picture.height / cell_);
  parts_.resize(static_cast<std::size_t>(across * down));
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      double sum = 0;
      int count = 0;
      for (int y = j * cell_; y < std::min((j + 1) * cell_, picture.height); y += 4)
        for (int x = i * cell_; x < std::min((i + 1) * cell_, picture.width); x += 4, ++count)
          sum += luminance(&picture.rgba[4 * (static_cast<std::size_t>(y) *
                                                  static_cast<std::size_t>(picture.width) +
                                              static_cast<std::size_t>(x))]);
      Part& part = parts_[static_cast<std::size_t>(j * across + i)];
      const double is = sum / std::max(count, 1);
      if (part.extreme < 0) part.extreme = is;
      const double change = is - part.extreme;
      const bool large = std::abs(change) >= kFlashStep && std::min(is, part.extreme) < kFlashDark;
      const int way = change > 0 ? 1 : -1;
      if (large && way != part.direction) {
        part.direction = way;
        part.changes.push_back(now);
        part.extreme = is;
      } else if (way == part.direction || part.direction == 0) {
        // Farther in the same direction: count a turn from the farthest.
        if (part.direction != 0) part.extreme = is;
      }
      // Two opposite changes are one flash.
      const auto since = std::count_if(part.changes.begin(), part.changes.end(),
                                       [&](double at) { return at > now - 1.0; });
      most_ = std::max(most_, static_cast<int>(since / 2));
    }
}

}  // namespace onggi::measure

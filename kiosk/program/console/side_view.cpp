#include "kiosk/program/console/side_view.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace onggi::console {

namespace {

constexpr double kSide = 100.0;  // of the picture, in its own units

/// The points of the outer wall, from the axis under the foot to the rim.
std::vector<Vec2> outer_wall(const std::vector<Vec2>& outline) {
  const auto rim = std::ranges::max_element(outline, {}, [](const Vec2& point) { return point.y; });
  return {outline.begin(), rim == outline.end() ? rim : rim + 1};
}

}  // namespace

std::string side_view(const Section& section) {
  const std::vector<Vec2> wall = outer_wall(section.outline);
  double height = 0, radius = 0;
  for (const Vec2& point : wall) {
    height = std::max(height, point.y);
    radius = std::max(radius, point.x);
  }
  if (height <= 0 || radius <= 0) return {};
  const double scale = kSide / std::max(height, 2 * radius);
  std::string path;
  const auto add = [&](double x, double y) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%c%.1f %.1f", path.empty() ? 'M' : 'L',
                  kSide / 2 + scale * x, kSide - scale * y);
    path += text.data();
  };
  for (const Vec2& point : wall) add(point.x, point.y);
  for (auto point = wall.rbegin(); point != wall.rend(); ++point) add(-point->x, point->y);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 100\"><path fill=\"#8c7b6b\" "
         "d=\"" +
         path + "Z\"/></svg>";
}

}  // namespace onggi::console

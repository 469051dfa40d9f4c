#include "kiosk/content/coloring.h"

#include <algorithm>
#include <cmath>

namespace onggi::content {

Coloring Coloring::part(std::size_t first, std::size_t count) const {
  const auto run = [&](const auto& all) {
    using List = std::decay_t<decltype(all)>;
    if (all.empty()) return List{};
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(first);
    return List(from, from + static_cast<std::ptrdiff_t>(count));
  };
  return {pictures, run(colors), run(places), run(picture)};
}

std::uint8_t display_of(float light) {
  const double v = std::clamp(static_cast<double>(light), 0.0, 1.0);
  const double out = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * out));
}

float light_of(std::uint8_t display) {
  const double v = display / 255.0;
  return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

}  // namespace onggi::content

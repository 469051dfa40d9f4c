#include "kiosk/collection/content/coloring.h"

#include <algorithm>
#include <cmath>

#include "kiosk/collection/textures/srgb.h"

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

namespace {

/// The pixel at `place` (1 is the whole side) of `count`.
std::size_t pixel_of(float place, int count, Coloring::Wrap wrap) {
  double at = place;
  if (wrap == Coloring::Wrap::repeat) at -= std::floor(at);
  if (wrap == Coloring::Wrap::mirror) {
    at -= 2.0 * std::floor(at / 2.0);
    if (at > 1.0) at = 2.0 - at;
  }
  const double n = std::clamp(at * count, 0.0, static_cast<double>(count - 1));
  return static_cast<std::size_t>(n);
}

}  // namespace

std::vector<std::array<float, 3>> baked(const Coloring& coloring) {
  std::vector<std::array<float, 3>> out;
  out.reserve(coloring.colors.size());
  for (std::size_t i = 0; i < coloring.colors.size(); ++i) {
    auto& light = out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) light[k] = light_of(coloring.colors[i][k]);
    if (coloring.picture.empty() || coloring.picture[i] == 0) continue;
    const Coloring::Picture& picture = coloring.pictures[coloring.picture[i] - 1u];
    const textures::TexturePixels& pixels = *picture.pixels;
    const std::size_t at = 3 * (pixel_of(coloring.places[i][1], pixels.height, picture.down) *
                                    static_cast<std::size_t>(pixels.width) +
                                pixel_of(coloring.places[i][0], pixels.width, picture.across));
    for (std::size_t k = 0; k < 3; ++k) light[k] *= light_of(pixels.rgb[at + k]);
  }
  return out;
}

std::uint8_t display_of(float light) {
  const double shown = textures::srgb_of_light(std::clamp(static_cast<double>(light), 0.0, 1.0));
  return static_cast<std::uint8_t>(std::lround(255.0 * shown));
}

float light_of(std::uint8_t display) {
  return static_cast<float>(textures::light_of_srgb(display / 255.0));
}

}  // namespace onggi::content

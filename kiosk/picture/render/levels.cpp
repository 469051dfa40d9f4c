#include "kiosk/picture/render/levels.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kQuarter = 1.57079633f;

}  // namespace

std::array<float, 2 * kLevels * 4> Levels::light() const {
  std::array<float, 2 * kLevels * 4> out{};
  const auto step = static_cast<float>(height / kLevels);
  for (std::size_t i = 0; i < kLevels; ++i) {
    // Outer wall: the highest shoulder above and the widest belly below, as angles in the meridian
    // plane from straight up and straight down.
    float over = -kQuarter, under = -kQuarter;
    for (std::size_t k = 0; k < kLevels; ++k) {
      if (k == i) continue;
      const float rise = step * (static_cast<float>(k) - static_cast<float>(i));
      const float lean = std::atan2(outer[k] - outer[i], std::abs(rise));
      (k > i ? over : under) = std::max(k > i ? over : under, lean);
    }
    const std::size_t below = i == 0 ? 0 : i - 1, above = std::min<std::size_t>(i + 1, kLevels - 1);
    const float slope = (outer[above] - outer[below]) / (step * static_cast<float>(above - below));
    const float normal = kQuarter + std::atan(slope);  // from straight up
    const float from = std::clamp(over - normal, -kQuarter, kQuarter);
    const float to = std::clamp(2 * kQuarter - under - normal, -kQuarter, kQuarter);
    const float seen = 0.5f * (std::sin(to) - std::sin(from));
    out[4 * i + 0] = outer[i];
    out[4 * i + 1] = over;
    // The occluding ring curves away to both sides, so the value in the plane occludes too much.
    out[4 * i + 2] = std::clamp(0.3f + 0.7f * seen, 0.0f, 1.0f);

    // Inner wall: the ring above that looks smallest from here.
    float ring = inner[i], at = step * (static_cast<float>(i) + 0.5f);
    float least = 1e9f;
    for (std::size_t k = i + 1; k <= kLevels; ++k) {
      const std::size_t j = std::min<std::size_t>(k, kLevels - 1);
      const float rise = step * (k == kLevels ? static_cast<float>(kLevels - i) - 0.5f
                                              : static_cast<float>(k - i));
      const float width = inner[j] / rise;
      if (width < least) {
        least = width;
        ring = inner[j];
        at = step * (static_cast<float>(i) + 0.5f) + rise;
      }
    }
    const std::size_t row = 4 * (kLevels + i);
    out[row + 0] = inner[i];
    out[row + 1] = ring;
    out[row + 2] = at;
  }
  return out;
}

double apart(const Levels& a, const Levels& b) {
  double most = std::abs(a.height - b.height);
  for (std::size_t i = 0; i < kLevels; ++i)
    most =
        std::max({most, std::abs(static_cast<double>(a.outer[i]) - static_cast<double>(b.outer[i])),
                  std::abs(static_cast<double>(a.inner[i]) - static_cast<double>(b.inner[i]))});
  return most;
}

void upload(const Levels& levels, Texture& texture) {
  const auto texels = levels.light();
  if (!texture.name) {
    texture = Texture::create(GL_RGBA32F, kLevels, 2, GL_RGBA, GL_FLOAT, texels.data());
    return;
  }
  calls::bind_texture(texture.name.get());
  calls::texture_part(0, 0, kLevels, 2, GL_RGBA, GL_FLOAT, texels.data());
}

}  // namespace onggi::render

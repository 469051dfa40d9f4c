#pragma once

#include <cmath>

namespace onggi::textures {

/// Linear light, 0..1, of a value as on a screen, 0..1 (sRGB: IEC 61966-2-1). No allocation.
inline double light_of_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The inverse: the value as on a screen of linear light, both 0..1.
inline double srgb_of_light(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

}  // namespace onggi::textures

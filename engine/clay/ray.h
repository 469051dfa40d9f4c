#pragma once

#include "engine/math/portable.h"

namespace onggi::clay {

/// Unit direction of a sector's ray in the clay's own frame: at the middle of the sector.
struct Ray {
  float cos, sin;
};
inline Ray ray_of(int sector, int sectors) noexcept {
  const double angle = (sector + 0.5) * 2.0 * portable::kPi / sectors;
  return {static_cast<float>(portable::cos(angle)), static_cast<float>(portable::sin(angle))};
}

}  // namespace onggi::clay

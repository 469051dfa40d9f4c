#pragma once

#include <algorithm>
#include <utility>

#include "engine/clay/clay.h"

namespace onggi {

inline constexpr double kRim = 0.2;  // m: the height of a fresh lump

// A wall that leans as a cone does: `slope` is dr/dy, both faces alike, `middle` the outer radius
// at half of its height. Its rows reach to the rim.
inline Clay cone(double slope, double thickness, double middle, int rows = 400) {
  ClayDef def;
  def.rows = rows;
  def.radius_max = 0.3;
  Clay clay = std::move(*Clay::create(def));
  for (int j = 0; j < clay.rows(); ++j) {
    const double out = middle + slope * (clay.row_height(j) - 0.5 * kRim);
    std::ranges::fill(clay.outer_mut(j), static_cast<float>(out));
    if (j >= clay.floor_rows())
      std::ranges::fill(clay.inner_mut(j), static_cast<float>(out - thickness));
    clay.set_extent(j, static_cast<float>(out), static_cast<float>(out - thickness));
    clay.mark_dirty(j);
  }
  return clay;
}

}  // namespace onggi

#pragma once

#include <vector>

#include "engine/clay/clay_view.h"

namespace onggi::device {

/// A wall `thick` metres thick, `radius` wide outside, 0.2 m high, on a floor of 10 mm.
inline ClayView tube(double radius, double thick = 0.006) {
  ClayDef def;
  def.rows = 100;
  def.sectors = 16;
  def.floor_thickness = 0.01;
  ClayView clay;
  clay.lay(def);
  const std::vector<float> outer(16, static_cast<float>(radius));
  const std::vector<float> inner(16, static_cast<float>(radius - thick));
  for (int j = 0; j < clay.rows(); ++j) clay.shape(j, outer, inner);
  return clay;
}

}  // namespace onggi::device

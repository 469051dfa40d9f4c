#pragma once

#include <span>
#include <vector>

namespace onggi {

/// A coil that lies on the rim and is not closed to a ring yet, for drawing. Clay frame.
struct CoilView {
  /// Distance of the coil's middle from the axis, by sector, m; 0 where nothing lies. Empty if
  /// nothing lies at all. Valid until the scene's next step.
  std::span<const float> centre;
  double diameter = 0.0;  ///< m
  double height = 0.0;    ///< Of the coil's middle, m.
  double added = 0.0;  ///< Clay that closed rings brought to the pot since the lump was laid, m^3.
};

/// The same to be kept and drawn: places at even angles round the axis, the n-th of N in the middle
/// of the n-th share of a turn. Clay frame.
struct CoilOnRim {
  std::vector<float> centre;  ///< Distance of the coil's middle from the axis, m; 0: nothing lies.
  double diameter = 0.0;      ///< m
  double height = 0.0;        ///< Of the coil's middle, m.
  friend bool operator==(const CoilOnRim&, const CoilOnRim&) = default;
};

}  // namespace onggi

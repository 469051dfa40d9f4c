#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A stamp (inhwa): presses its relief into soft leather-hard clay; slip goes down with the clay.
/// Twice at one place is once.
struct StampDef {
  int side = 0;         ///< Cells of the picture across and up, 2..64.
  double size = 0.008;  ///< Of its side, m, 0.003..0.015 on a pot of full size, 0.001..0.03 here.
  double depth = 6e-4;  ///< Of the deepest cell at whole pressure, m, 0..0.001.
  std::vector<std::uint8_t> picture;  ///< side x side, 255 the deepest; from its lower left.

  static constexpr const char* kName = "stamp";
  static std::span<const DefField<StampDef, int>> counts();
  static std::span<const DefField<StampDef>> fields();
};

/// Presses it at each of `stations`, its up the way that the station goes. `def` and `stations` are
/// valid (laws.h).
Work stamp(Surface& surface, const StampDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

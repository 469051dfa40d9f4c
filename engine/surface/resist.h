#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// Wax from a brush, or fingers that hold the pot while it is dipped: slip and glaze stay away from
/// what is covered.
struct ResistDef {
  double width = 0.012;  ///< m, 0.001..0.03.
  bool lifts = false;    ///< Uncovers instead: fingers let go, wax burns.

  static constexpr const char* kName = "resist";
  static std::span<const DefField<ResistDef>> fields();
  static std::span<const DefField<ResistDef, bool>> switches();
};

/// Covers the way along `stations`, with round ends. `def` and `stations` are valid (laws.h).
Work resist(Surface& surface, const ResistDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

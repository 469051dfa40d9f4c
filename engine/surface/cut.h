#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A needle, a knife, a loop or a comb: takes clay, and what lies on it, down to its section.
/// Depths are under the reference body, so the same cut again takes nothing.
struct CutDef {
  /// What a tooth leaves: `sunk` is deep and upright on the left of its way and rises to nothing on
  /// the right.
  enum Section { v, u, flat, sunk };

  int section = v;        ///< Of Section, 0..3.
  int teeth = 1;          ///< Side by side, 1..9: more than one is a comb.
  double width = 5e-4;    ///< Of a tooth, m, 2e-4..0.01.
  double depth = 4e-4;    ///< At whole pressure, m, 0..0.003. Never more than kMostCut of the wall.
  double spacing = 2e-3;  ///< From tooth to tooth, m, 5e-4..0.006.
  double burr = 0.2;      ///< Share of the taken clay that stands up beside the cut, 0..0.5.

  static constexpr const char* kName = "cut";
  static std::span<const DefField<CutDef, int>> counts();
  static std::span<const DefField<CutDef>> fields();
};

/// Cuts along `stations`. A single one leaves a dot. `def` and `stations` are valid (laws.h).
Work cut(Surface& surface, const CutDef& def, std::span<const Station> stations);

/// Takes away loose clay that stands over the reference body, as a burr does.
void brush_off(Surface& surface, int j, int i);

}  // namespace onggi::surface

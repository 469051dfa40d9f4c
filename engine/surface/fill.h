#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A figure that is painted over its whole area with an even coat: a petal, a diamond, a letter.
/// Its stations are its corners. One that crosses itself is filled where an odd number of its turns
/// go round.
struct FillDef {
  int pigment = 0;            ///< 0..15.
  double thickness = 1.5e-4;  ///< Of the dry coat, m, 2e-6..0.002.

  static constexpr const char* kName = "fill";
  static std::span<const DefField<FillDef, int>> counts();
  static std::span<const DefField<FillDef>> fields();
};

/// Lays the coat on each cell whose middle lies within the corners, where there is no resist. Twice
/// is once. `def` and `stations` are valid (laws.h).
Work fill(Surface& surface, const FillDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

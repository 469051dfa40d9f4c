#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A brush with slip, gloss or oxide. It lays an even coat while it is full, then a thinner and
/// narrower one, and streaks at the end. A band on the turning wheel is such a stroke, too.
struct BrushDef {
  int pigment = 0;            ///< 0..15.
  int tracks = 7;             ///< Of hair, across, each with a load of its own, 1..9.
  double width = 0.01;        ///< When full and pressed, m, 5e-4..0.04.
  double thickness = 1.5e-4;  ///< Of the dry coat of a full brush, m, 2e-6..0.002.
  /// Share of a hollow under the reference body that the slip fills besides, 0..1: 0.67 for an
  /// inlay, whose slip sinks by a third as it dries.
  double fill = 0.0;
  double reach = 0.4;  ///< Way of a full brush, m, 0.01..100: for a Tracer. Longer: fresh dips.

  static constexpr const char* kName = "brush";
  static std::span<const DefField<BrushDef, int>> counts();
  static std::span<const DefField<BrushDef>> fields();
};

/// Lays slip along `stations`, where there is no resist, and brushes burrs off. `def` and
/// `stations` are valid (laws.h).
Work brush(Surface& surface, const BrushDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

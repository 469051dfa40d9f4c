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
  double reach = 0.4;      ///< Way of a full brush, m, 0.01..100: for a Tracer. Longer: fresh dips.
  double drags = 0.1;      ///< Share of the wet slip under it that goes along, 0..0.5.
  double wet_time = 10.0;  ///< Until slip on leather-hard clay is dry, s, 1..3600.

  static constexpr const char* kName = "brush";
  static std::span<const DefField<BrushDef, int>> counts();
  static std::span<const DefField<BrushDef>> fields();
};

/// Lays slip along `stations`, where there is no resist, and brushes burrs off. Before that it
/// takes its share of the top stratum that is still wet from each cell, and spreads it over the 2
/// mm ahead, where the next pieces of the way find it: none is lost. `def` and `stations` are valid
/// (laws.h).
Work brush(Surface& surface, const BrushDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

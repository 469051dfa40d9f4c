#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A smooth stone rubs dry clay or slip: each pass polishes it more, up to kMostBurnish.
struct BurnishDef {
  double width =
      0.005;  ///< Of the stone's touch, m, 0.003..0.008 on a pot of full size, 0.001..0.02.

  static constexpr const char* kName = "burnish";
  static std::span<const DefField<BurnishDef>> fields();
};

/// Roughness of a polished cell, 0..1: 0.7 untouched, 0.25 after three passes.
double roughness(int passes);

/// Rubs along `stations`; glazed cells and covered ones are left. `def` and `stations` are valid
/// (laws.h).
Work burnish(Surface& surface, const BurnishDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

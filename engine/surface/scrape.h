#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A straight blade that follows the reference body: it takes all that stands over that body less
/// `take`. Inlay, reverse inlay and clean edges are what it leaves. A second time takes nothing.
struct ScrapeDef {
  double width = 0.02;  ///< m, 0.001..0.04.
  double take = 1e-4;   ///< Of the body, at whole pressure, m, 0..2e-4.

  static constexpr const char* kName = "scrape";
  static std::span<const DefField<ScrapeDef>> fields();
};

/// Scrapes along `stations`. `def` and `stations` are valid (laws.h).
Work scrape(Surface& surface, const ScrapeDef& def, std::span<const Station> stations);

}  // namespace onggi::surface

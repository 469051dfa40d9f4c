#include "engine/surface/scrape.h"

#include <algorithm>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<ScrapeDef>> ScrapeDef::fields() {
  static constexpr DefField<ScrapeDef> kFields[] = {
      {"width", &ScrapeDef::width, 0.001, 0.04, "m"},
      {"take", &ScrapeDef::take, 0.0, 2e-4, "m"},
  };
  return kFields;
}

Work scrape(Surface& surface, const ScrapeDef& def, std::span<const Station> stations) {
  Work work;
  const std::int64_t half = micrometres(def.width) / 2;
  for (std::size_t n = 1; n < stations.size(); ++n) {
    const Station &from = stations[n - 1], &to = stations[n];
    if (to.pressure == 0) continue;
    const std::int64_t take = micrometres(def.take) * to.pressure / kWhole;
    each_cell_in(surface, piece(surface, from, to, -half, half, -half, half), [&](int j, int i) {
      trim(surface, j, i, -std::min<std::int64_t>(take, surface.deepest(j)) * kNanometres, work);
    });
  }
  return work;
}

}  // namespace onggi::surface

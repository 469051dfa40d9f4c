#include "engine/surface/burnish.h"

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<BurnishDef>> BurnishDef::fields() {
  static constexpr DefField<BurnishDef> kFields[] = {
      {"width", &BurnishDef::width, 0.001, 0.02, "m"}};
  return kFields;
}

double roughness(int passes) { return 0.7 - 0.15 * passes; }

Work burnish(Surface& surface, const BurnishDef& def, std::span<const Station> stations) {
  const std::int64_t half = micrometres(def.width) / 2;
  for (std::size_t n = 1; n < stations.size(); ++n) {
    if (stations[n].pressure == 0) continue;
    each_cell_in(surface, piece(surface, stations[n - 1], stations[n], -half, half, -half, half),
                 [&](int j, int i) {
                   if (surface.glaze(j, i) == 0 && !surface.resist(j, i))
                     surface.set_burnish(j, i, surface.burnish(j, i) + 1);
                 });
  }
  return {};
}

}  // namespace onggi::surface

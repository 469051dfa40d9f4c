#include "engine/surface/resist.h"

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<ResistDef>> ResistDef::fields() {
  static constexpr DefField<ResistDef> kFields[] = {{"width", &ResistDef::width, 0.001, 0.03, "m"}};
  return kFields;
}

std::span<const DefField<ResistDef, bool>> ResistDef::switches() {
  static constexpr DefField<ResistDef, bool> kSwitches[] = {{"lifts", &ResistDef::lifts, 0, 1, ""}};
  return kSwitches;
}

Work resist(Surface& surface, const ResistDef& def, std::span<const Station> stations) {
  const std::int64_t half = micrometres(def.width) / 2;
  for (std::size_t n = 0; n < stations.size(); ++n) {
    if (stations[n].pressure == 0) continue;
    const Corner from = beside(surface, stations[n == 0 ? 0 : n - 1], 0);
    each_cell_near(
        surface, from, beside(surface, stations[n], 0), half,
        [&](int j, int i, std::int64_t, std::int64_t) { surface.set_resist(j, i, !def.lifts); });
  }
  return {};
}

}  // namespace onggi::surface

#include "engine/surface/fill.h"

#include <algorithm>
#include <vector>

#include "engine/surface/cut.h"
#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<FillDef, int>> FillDef::counts() {
  static constexpr DefField<FillDef, int> kCounts[] = {
      {"pigment", &FillDef::pigment, 0, kPigments - 1, ""}};
  return kCounts;
}

std::span<const DefField<FillDef>> FillDef::fields() {
  static constexpr DefField<FillDef> kFields[] = {
      {"thickness", &FillDef::thickness, 2e-6, 0.002, "m"}};
  return kFields;
}

namespace {

/// Where the figure's edges cross the middle of row j, in order: it is filled from the first to the
/// second, from the third to the fourth.
void crossings_of(std::span<const Station> corners, int j, std::vector<std::int64_t>& crossings) {
  crossings.clear();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Station &from = corners[k], &to = corners[(k + 1) % corners.size()];
    if (const auto at = crossing_of({from.along, from.round}, {to.along, to.round},
                                    std::int64_t{j} * kRowHeight + kRowHeight / 2))
      crossings.push_back(*at);
  }
  std::ranges::sort(crossings);
}

}  // namespace

Work fill(Surface& surface, const FillDef& def, std::span<const Station> stations) {
  Work work;
  const int code = code_within(nanometres(def.thickness));
  const auto along = [](const Station& at) { return at.along; };
  const auto [low, high] = std::ranges::minmax(stations, {}, along);
  const int first = row_of(surface, low.along), last = row_of(surface, high.along);
  std::vector<std::int64_t> crossings;
  for (int j = first; j <= last; ++j) {
    crossings_of(stations, j, crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      for (std::int64_t sector = crossings[k]; sector < crossings[k + 1]; ++sector) {
        const int i = wrapped(sector);
        brush_off(surface, j, i);
        if (surface.resist(j, i)) continue;
        work.slip_laid += coat_slip(surface, j, i, def.pigment, code);
        surface.set_burnish(j, i, 0);
      }
  }
  return work;
}

}  // namespace onggi::surface

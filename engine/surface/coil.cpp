#include "engine/surface/coil.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<CoilDef, int>> CoilDef::counts() {
  static constexpr DefField<CoilDef, int> kCounts[] = {
      {"marks", &CoilDef::marks, 8, 120, ""}, {"turn", &CoilDef::turn, 0, kSectors - 1, ""}};
  return kCounts;
}

std::span<const DefField<CoilDef>> CoilDef::fields() {
  static constexpr DefField<CoilDef> kFields[] = {
      {"width", &CoilDef::width, 0.002, 0.015, "m"},
      {"height", &CoilDef::height, 0.0, 0.003, "m"},
      {"press", &CoilDef::press, 0.0, 1.0, ""},
  };
  return kFields;
}

namespace {

/// How much of the bead stands in a cell after the nail, of kWhole. A mark takes 60 % of its share
/// of the turn, deepest in its middle, and leans by two sectors a row.
std::int64_t left_by_nail(const CoilDef& def, std::int64_t press, int j, int i) {
  constexpr std::int64_t kLean = 2 * kParts;
  const std::int64_t turn = std::int64_t{kTurn};
  const std::int64_t at = std::int64_t{i - def.turn} * kParts + kParts / 2 + j * kLean;
  const std::int64_t in_turn = at - floor_div(at, turn) * turn;
  const std::int64_t phase = in_turn * def.marks % turn;  // kTurn from a mark to the next
  const std::int64_t off =
      std::abs(phase - turn / 2) * kWhole * 10 / (turn * 3);  // kWhole: its edge
  if (off >= kWhole) return kWhole;
  return kWhole - press * (kWhole * kWhole - off * off) / (std::int64_t{kWhole} * kWhole);
}

}  // namespace

Work coil(Surface& surface, const CoilDef& def, std::span<const Station> stations) {
  Work work;
  const std::int64_t half = micrometres(def.width) / 2;
  const std::int64_t press = micrometres(def.press) * kWhole / 1'000'000;
  const std::size_t first = stations.size() == 1 ? 0 : 1;
  for (std::size_t n = first; n < stations.size(); ++n) {
    const Station& to = stations[n];
    if (to.pressure == 0) continue;
    const std::int64_t height = micrometres(def.height) * to.pressure / kWhole;
    each_cell_near(
        surface, beside(surface, stations[n == 0 ? 0 : n - 1], 0), beside(surface, to, 0), half,
        [&](int j, int i, std::int64_t distance, std::int64_t) {
          const auto square = static_cast<double>(half * half - distance * distance);
          const std::int64_t bead = height * static_cast<std::int64_t>(std::sqrt(square)) / half;
          const auto high = static_cast<int>(bead * left_by_nail(def, press, j, i) / kWhole);
          const int was = surface.relief(j, i);
          if (high <= was) return;
          surface.set_relief(j, i, high);
          surface.set_coil(j, i, true);
          work.clay_laid += Volume{high - was} * kNanometres * surface.row(j).area;
        });
  }
  return work;
}

}  // namespace onggi::surface

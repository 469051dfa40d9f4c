#include "engine/surface/cut.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<CutDef, int>> CutDef::counts() {
  static constexpr DefField<CutDef, int> kCounts[] = {{"section", &CutDef::section, 0, 3, ""},
                                                      {"teeth", &CutDef::teeth, 1, 9, ""}};
  return kCounts;
}

std::span<const DefField<CutDef>> CutDef::fields() {
  static constexpr DefField<CutDef> kFields[] = {
      {"width", &CutDef::width, 2e-4, 0.01, "m"},
      {"depth", &CutDef::depth, 0.0, 0.003, "m"},
      {"spacing", &CutDef::spacing, 5e-4, 0.006, "m"},
      {"burr", &CutDef::burr, 0.0, 0.5, ""},
  };
  return kFields;
}

namespace {

/// Of a tooth whose half width is `half`, at `distance` (0..half) from its way and `left` of it. A
/// slanted one has its slant before and behind it, too. All um.
std::int64_t depth_at(int section, std::int64_t depth, std::int64_t half, std::int64_t distance,
                      std::int64_t left) {
  switch (section) {
    case CutDef::v:
      return depth * (half - distance) / half;
    case CutDef::u: {
      const auto square = static_cast<double>(half * half - distance * distance);
      return depth * static_cast<std::int64_t>(std::sqrt(square)) / half;
    }
    case CutDef::sunk:
      return depth * std::clamp<std::int64_t>(half + left, 0, 2 * half) / (2 * half);
    default:
      return depth;
  }
}

/// The clay of a tooth's way beside which a burr stands.
class Tooth {
 public:
  Tooth(Surface& surface, const CutDef& def, int tooth)
      : surface_(surface),
        def_(def),
        half_(micrometres(def.width) / 2),
        offset_(micrometres(def.spacing) * (2 * tooth - def.teeth + 1) / 2) {}

  void go(const Station& from, const Station& to, Work& work) {
    if (to.pressure == 0) return;
    const Volume before = work.clay_taken;
    const std::int64_t depth = micrometres(def_.depth) * to.pressure / kWhole;
    each_cell_near(surface_, beside(surface_, from, offset_), beside(surface_, to, offset_), half_,
                   [&](int j, int i, std::int64_t distance, std::int64_t left) {
                     const std::int64_t cut = depth_at(def_.section, depth, half_, distance, left);
                     const std::int64_t most = surface_.deepest(j);
                     trim(surface_, j, i, -std::min(cut, most) * kNanometres, work);
                   });
    raise_burr(from, to, work.clay_taken - before);
  }

 private:
  static constexpr std::int64_t kLeastBurr = 300;  // um wide: a cell or two
  static constexpr std::int64_t kClear = 10;       // um from the cut, for both edges are rounded
  static constexpr int kGroove = -200;  // um: deeper than a scrape is a groove, which stays open
  static constexpr int kHighestBurr = 1500;  // um

  void raise_burr(const Station& from, const Station& to, Volume taken) {
    beside_.clear();
    const std::int64_t wide = std::max(half_ / 2, kLeastBurr);
    for (const std::int64_t side : {offset_ - half_ - kClear - wide, offset_ + half_ + kClear})
      each_cell_in(surface_, piece(surface_, from, to, side, side + wide, side, side + wide),
                   [&](int j, int i) {
                     if (surface_.relief(j, i) >= kGroove) beside_.emplace_back(j, i);
                   });
    const int rest_row = row_of(surface_, to.along);
    Volume stands = taken * (micrometres(def_.burr) / 1000) / 1000 +
                    surface_.rest(rest_row, Surface::kBurrRest);
    Volume area = 0;
    for (const auto& [j, i] : beside_) area += surface_.row(j).area;
    if (area > 0) {
      const Volume high = stands / (area * kNanometres);  // um
      for (const auto& [j, i] : beside_) {
        const int was = surface_.relief(j, i);
        surface_.set_relief(
            j, i, std::max(was, static_cast<int>(std::min<Volume>(was + high, kHighestBurr))));
        stands -= (surface_.relief(j, i) - was) * kNanometres * surface_.row(j).area;
      }
      // What finds no place on a burr that is as high as can be has crumbled.
      stands = std::min(stands, area * kNanometres);
    }
    surface_.set_rest(rest_row, Surface::kBurrRest, stands);
  }

  Surface& surface_;
  const CutDef& def_;
  std::int64_t half_, offset_;
  std::vector<std::pair<int, int>> beside_;
};

}  // namespace

Work cut(Surface& surface, const CutDef& def, std::span<const Station> stations) {
  Work work;
  std::vector<Tooth> teeth;
  for (int tooth = 0; tooth < def.teeth; ++tooth) teeth.emplace_back(surface, def, tooth);
  const std::size_t first = stations.size() == 1 ? 0 : 1;
  for (std::size_t n = first; n < stations.size(); ++n)
    for (Tooth& tooth : teeth) tooth.go(stations[n == 0 ? 0 : n - 1], stations[n], work);
  return work;
}

void brush_off(Surface& surface, int j, int i) {
  if (surface.relief(j, i) > 0 && !surface.coil(j, i)) surface.set_relief(j, i, 0);
}

}  // namespace onggi::surface

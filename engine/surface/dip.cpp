#include "engine/surface/dip.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<DipDef, int>> DipDef::counts() {
  static constexpr DefField<DipDef, int> kCounts[] = {{"coat", &DipDef::coat, 0, kGlaze, ""}};
  return kCounts;
}

std::span<const DefField<DipDef>> DipDef::fields() {
  static constexpr DefField<DipDef> kFields[] = {
      {"from", &DipDef::from, 0.0, 2.1, "m"},        {"to", &DipDef::to, 0.0, 2.1, "m"},
      {"seconds", &DipDef::seconds, 0.1, 60.0, "s"}, {"rate", &DipDef::rate, 1e-5, 1e-3, "m"},
      {"drinks", &DipDef::drinks, 0.01, 1.0, ""},
  };
  return kFields;
}

namespace {

/// What a coat of `old` nm has grown to on a wall of `most`, nm: a thick coat grows slowly.
std::int64_t grown(std::int64_t old, double fresh, std::int64_t most) {
  const auto before = static_cast<double>(old);
  const auto now = static_cast<std::int64_t>(std::sqrt(before * before + fresh * fresh));
  return std::max(old, std::min(now, most));
}

void coat_cell(Surface& surface, const DipDef& def, int j, int i, double fresh, std::int64_t most,
               Work& work) {
  if (def.coat == DipDef::kGlaze) {
    const int old = surface.glaze(j, i);
    const std::int64_t nm = grown(std::int64_t{old} * kGlazeUnit, fresh, most);
    surface.set_glaze(j, i, static_cast<int>(std::min<std::int64_t>(nm / kGlazeUnit, kMostGlaze)));
    work.glaze_laid += Volume{surface.glaze(j, i) - old} * kGlazeUnit * surface.row(j).area;
    return;
  }
  const Stratum top = surface.slip(j, i).at(0);
  const int old = top.pigment == def.coat ? thickness_of(top.code) : 0;
  if (const int code = code_within(grown(old, fresh, most)); code > 0)
    work.slip_laid += coat_slip(surface, j, i, def.coat, code);
}

}  // namespace

Work dip(Surface& surface, const DipDef& def) {
  Work work;
  const double fresh = std::floor(def.rate * std::sqrt(def.seconds) * 1e9);
  const std::int64_t from = micrometres(def.from), to = micrometres(def.to);
  for (int j = 0; j < surface.rows(); ++j) {
    const std::int64_t middle = std::int64_t{j} * kRowHeight + kRowHeight / 2;
    if (middle < from || middle >= to) continue;
    const auto most = static_cast<std::int64_t>(surface.row(j).wall * def.drinks * 1e3);
    for (int i = 0; i < kSectors; ++i)
      if (!surface.resist(j, i)) coat_cell(surface, def, j, i, fresh, most, work);
  }
  return work;
}

}  // namespace onggi::surface

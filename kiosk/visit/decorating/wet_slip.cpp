#include "kiosk/visit/decorating/wet_slip.h"

#include <algorithm>
#include <cmath>

namespace onggi::decorating {

bool WetSlip::lays(const surface::Tool& tool) {
  if (const auto* dip = std::get_if<surface::DipDef>(&tool))
    return dip->coat != surface::DipDef::kGlaze;
  return std::holds_alternative<surface::BrushDef>(tool) ||
         std::holds_alternative<surface::FillDef>(tool);
}

void WetSlip::lay(const surface::Surface& surface, const Part& part) {
  double top = 0.0;
  for (int j = 0; j < surface.rows(); ++j) top = std::max(top, surface.row(j).height);
  if (top <= 0.0) return;
  wet_.resize(kLevels, 0.0f);
  for (int j = std::max(part.from, 0); j < std::min(part.to, surface.rows()); ++j) {
    const double level = surface.row(j).height / top * (kLevels - 1);
    wet_[static_cast<std::size_t>(std::clamp(std::lround(level), 0L, kLevels - 1L))] = 1.0f;
  }
}

void WetSlip::dry(double seconds) {
  if (wet_.empty()) return;
  for (float& wet : wet_) wet = std::max(wet - static_cast<float>(seconds / kDries), 0.0f);
  if (std::ranges::all_of(wet_, [](float wet) { return wet <= 0.0f; })) wet_.clear();
}

}  // namespace onggi::decorating

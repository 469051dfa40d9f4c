#include "kiosk/visit/decorating/touched_part.h"

#include <algorithm>

namespace onggi::decorating {

namespace {

using surface::floor_div;
using surface::kRowHeight;
using surface::kSectors;

constexpr double kDrags = 0.002;  // m: a brush takes wet slip along before it

struct Reach {
  double operator()(const surface::CutDef& def) const {
    return 0.5 * (def.width + (def.teeth - 1) * def.spacing) + 0.002;
  }
  double operator()(const surface::WipeDef& def) const { return 2.0 * def.width; }
  double operator()(const surface::StampDef& def) const { return 0.75 * def.size; }
  double operator()(const surface::FillDef&) const { return 0.0; }
  double operator()(const surface::DipDef&) const { return 0.0; }
  double operator()(const surface::SmokeDef&) const { return 0.0; }
  double operator()(const auto& def) const { return 0.5 * def.width; }
};

}  // namespace

double reach_of(const surface::Tool& tool) { return std::visit(Reach{}, tool) + 5e-4; }

Part touched_part(const surface::Surface& surface, const surface::Stroke& stroke) {
  Part part{surface.rows(), 0, 0, kSectors};
  if (const auto* dip = std::get_if<surface::DipDef>(&stroke.tool)) {
    part.from = static_cast<int>(dip->from * 1e6) / kRowHeight;
    part.to = static_cast<int>(dip->to * 1e6) / kRowHeight + 1;
    return part;
  }
  if (stroke.stations.empty()) return {0, surface.rows(), 0, kSectors};
  const bool brush = std::holds_alternative<surface::BrushDef>(stroke.tool);
  const double reach = reach_of(stroke.tool) + (brush ? kDrags : 0.0);
  const auto rows = static_cast<int>(reach * 1e6) / kRowHeight + 1;
  part.first = kSectors * surface::kMostTurns, part.last = -part.first;
  for (const surface::Station& at : stroke.stations) {
    const int row = std::clamp(at.along / kRowHeight, 0, surface.rows() - 1);
    const auto sectors = static_cast<int>(
        std::min(reach * 1e9 / std::max(surface.row(row).width, 1), 1.0 * kSectors));
    const auto sector = static_cast<int>(floor_div(at.round, surface::kParts));
    part.from = std::min(part.from, row - rows), part.to = std::max(part.to, row + rows + 1);
    part.first = std::min(part.first, sector - sectors - 1);
    part.last = std::max(part.last, sector + sectors + 2);
  }
  return part;
}

}  // namespace onggi::decorating

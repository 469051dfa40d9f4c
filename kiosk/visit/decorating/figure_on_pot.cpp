#include "kiosk/visit/decorating/figure_on_pot.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kiosk/collection/decoration/figure.h"

namespace onggi::decorating {

namespace {

constexpr double kOfItsRoom = 0.94;                   // of the way round from a figure to the next
constexpr double kAllRound = 2.0 * 3.14159265358979;  // rad

/// A figure's extent, in its units.
struct Extent {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
};

Extent extent_of(const decoration::Motif& motif) {
  Extent extent;
  for (const auto* ways : {&motif.fills, &motif.lines})
    for (const auto& points : *ways)
      for (const Vec2& p : points) {
        extent.left = std::min(extent.left, p.x), extent.right = std::max(extent.right, p.x);
        extent.low = std::min(extent.low, p.y), extent.high = std::max(extent.high, p.y);
      }
  return extent;
}

}  // namespace

FigureOnPot figure_on_pot(const surface::Surface& surface, const decoration::WayTool& tool,
                          const surface::Tool& law, const decoration::Motif& motif,
                          const Zones& zones, double outside, int repeats, const Place& at) {
  const Extent extent = extent_of(motif);
  const int row = static_cast<int>(at.along * 1e6) / surface::kRowHeight;
  const double room =
      kAllRound * surface.row(std::clamp(row, 0, surface.rows() - 1)).radius / repeats;
  const double size =
      std::min(tool.size, kOfItsRoom * room / std::max(extent.right - extent.left, 0.1));
  const double along = zones.within(at.along, -size * extent.low, size * extent.high);
  const bool inside = at.along > outside;
  if (const auto* stamp = std::get_if<surface::StampDef>(&law))
    return {{decoration::stamp_stroke(*stamp, motif, size, along, at.turns, inside)},
            along,
            size,
            inside};
  std::optional<surface::FillDef> fill;
  if (const auto* brush = std::get_if<surface::BrushDef>(&law)) {
    fill.emplace();
    fill->pigment = brush->pigment;
    fill->thickness = brush->thickness;
  }
  const auto place = decoration::figure_place(surface, along, at.turns, size, inside);
  return {decoration::figure_strokes(surface, motif, place, law, fill), along, size, inside};
}

}  // namespace onggi::decorating

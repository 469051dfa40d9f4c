#pragma once

#include <vector>

#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/way.h"
#include "kiosk/visit/decorating/touched_place.h"
#include "kiosk/visit/decorating/zones.h"

namespace onggi::decorating {

/// A figure at its place.
struct FigureOnPot {
  std::vector<surface::Stroke> strokes;  ///< Taken back together.
  double along = 0.0, size = 0.0;        ///< Where its middle is; its height, m.
  bool inside = false;
};

/// The strokes that set `motif` once on a pot, as `tool` does, with its middle at `at` or as far
/// off as its zone asks (Zones::within). `law`: the tool's, with the chosen pigment; its areas are
/// filled by a brush, and a stamp presses them. Smaller than WayTool::size where `repeats` of it
/// round the pot would overlap. `outside`: the length of the outline from the foot to the lip, m.
/// Allocates.
FigureOnPot figure_on_pot(const surface::Surface& surface, const decoration::WayTool& tool,
                          const surface::Tool& law, const decoration::Motif& motif,
                          const Zones& zones, double outside, int repeats, const Place& at);

}  // namespace onggi::decorating

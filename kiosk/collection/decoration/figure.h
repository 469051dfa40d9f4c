#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/motif.h"

namespace onggi::decoration {

/// The way of a brush that is dipped again before it runs dry, m.
inline constexpr double kEndlessWay = 100.0;

/// Where a figure stands on a surface: its middle, and what one of its units is.
struct FigurePlace {
  double along = 0.0, turns = 0.0;  ///< m from the foot along the outline; round the pot.
  double up = 1.0, round = 1.0;     ///< m and turns in one unit of the figure.
};

/// The place of a figure `size` m high at `along` and `turns`. `inside`: it is looked at from
/// within.
FigurePlace figure_place(const surface::Surface& surface, double along, double turns, double size,
                         bool inside);

/// Stations along a figure's line; `closed`: back to its first point. `reach`: of a full brush, m.
std::vector<surface::Station> way_of(const surface::Surface& surface,
                                     const std::vector<Vec2>& points, const FigurePlace& at,
                                     bool closed, double reach = kEndlessWay);

/// The areas of `motif` as a stamp's picture of `side` x `side` cells, from its lower left: 255
/// where an area is, 0 elsewhere. The stamp's side is one unit of the figure. Allocates.
std::vector<std::uint8_t> stamp_picture(const Motif& motif, int side);

/// One touch of a stamp of `motif`'s areas, `size` m high, upright as it is looked at: from within
/// where `inside`. Allocates.
surface::Stroke stamp_stroke(surface::StampDef stamp, const Motif& motif, double size, double along,
                             double turns, bool inside);

/// The strokes that draw `motif`: its lines by `line`, its areas by `fill`, or where there is none
/// their outlines by `line`; a flat cut takes the whole area. Taken back together. Empty for a
/// motif without anything.
std::vector<surface::Stroke> figure_strokes(const surface::Surface& surface, const Motif& motif,
                                            const FigurePlace& at, const surface::Tool& line,
                                            const std::optional<surface::FillDef>& fill);

}  // namespace onggi::decoration

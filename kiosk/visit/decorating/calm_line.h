#pragma once

#include <vector>

#include "engine/surface/station.h"

namespace onggi::decorating {

/// A finger's next part of a free line, made calm.
struct CalmPart {
  std::vector<surface::HandPlace> way;  ///< Where the tool goes now; empty: nowhere.
  surface::HandPlace tip;               ///< Where the string's end is: the next corner.
};

/// Of a string's length that the finger may shake before the tool follows, m.
inline constexpr double kSlack = 0.0015;

/// The tool stands at `drawn` and hangs on a short string, whose end is at `tip`; the finger goes
/// to `along` and by `turns` round, where the pot has this `radius`, m. The tool's way is a curve
/// through the middles between the places of the string's end (they are the corners of a quadratic
/// B-spline), so a shaking or a far too quick finger draws a calm line.
CalmPart calm_part(const surface::HandPlace& drawn, const surface::HandPlace& tip, double along,
                   double turns, double radius);

}  // namespace onggi::decorating

#pragma once

#include "engine/surface/laws.h"

namespace onggi::decorating {

/// Cells of a surface: the rows [from, to) and the sectors [first, last), which may go round.
struct Part {
  int from = 0, to = 0, first = 0, last = 0;
};

/// The cells that `stroke` can change, and some beside them.
Part touched_part(const surface::Surface& surface, const surface::Stroke& stroke);

/// How far from its stations a tool works, m. Slip that a brush drags along comes further.
double reach_of(const surface::Tool& tool);

}  // namespace onggi::decorating

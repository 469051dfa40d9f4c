#pragma once

#include <span>

#include "engine/effects/prints.h"
#include "engine/surface/surface.h"

namespace onggi::decorating {

/// Prints what paddle and anvil left on a pot on its bare `surface` (surface::imprint). True if
/// something is to be seen: plain wood and a smooth anvil leave nothing, and what was smoothed is
/// gone. The paddle turns about the potter's elbow, so its face leans as it strikes high or low,
/// and to the other side for a hand on the left. Allocates.
bool print(surface::Surface& surface, std::span<const Print> prints, const PrintsDef& faces);

}  // namespace onggi::decorating

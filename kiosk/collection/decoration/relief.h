#pragma once

#include "engine/surface/surface.h"
#include "kiosk/collection/decoration/unrolled.h"

namespace onggi::decoration {

/// Height of all that was cut and laid over the reference body, m, at a place of the unrolled
/// picture: `across` round the pot, where 1 is a whole turn and more goes on; `down` 0..1 over the
/// rows, from the foot. Straight between the middles of the four cells round it.
double height_at(const surface::Surface& surface, double across, double down);

/// Its mean over a field round that place, as wide and high as these shares of the picture: over
/// the cells whose middles lie in it, one cell at least. O(cells).
double mean_height(const surface::Surface& surface, double across, double down, double wide,
                   double high);

/// The relief as a picture of normals, as glTF 2.0 wants it (3.9.3): red is the share round the
/// pot, in the direction of the sectors, green that towards the picture's top, which is against the
/// rows, blue that out of the clay; 0..255 is -1..1. Each pixel has the mean slope of its cells.
/// With slopes a along the rows and r round the pot, times `share`,
///   n = (-r, a, 1) / sqrt(1 + a^2 + r^2).
/// `share` is 1 for a bare surface, and less under glass, which runs level, 0..1. `width` and
/// `height` in pixels, 1 or more; places as in unrolled(). Allocates. O(cells).
Unrolled normals_of(const surface::Surface& surface, int width, int height, double share);

}  // namespace onggi::decoration

#pragma once

#include <optional>

#include "engine/surface/surface.h"
#include "kiosk/picture/view/camera.h"

namespace onggi::decorating {

/// A place on a pot's surface.
struct Place {
  double along = 0.0;  ///< From the foot along the outline, m.
  double turns = 0.0;  ///< Round the pot from its own angle 0, 0..1.
};

/// What of the pot is under a pixel: the wall, lip or floor that is nearest to the eye. `turned`:
/// the pot's angle on the wheel, rad. Nothing beside it. Looks at every row, some 20 us.
std::optional<Place> place_under(const view::Camera& camera, const surface::Surface& surface,
                                 double turned, float x, float y);

}  // namespace onggi::decorating

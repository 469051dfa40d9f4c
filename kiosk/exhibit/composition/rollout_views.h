#pragma once

#include <span>
#include <vector>

#include "engine/math/vec.h"
#include "kiosk/exhibit/composition/cones.h"
#include "kiosk/picture/view/image.h"

namespace onggi::exhibit {

// Other views of a pot's outside, drawn from its strip (UnrolledPot::rollout()): once round from
// the left, true along the outline, the foot below. On a transparent ground. `outline`: evenly
// spaced points from the foot to the strip's upper edge, m; x: radius, y: height.

/// The outside from the side, as an archaeologist draws a view: without perspective, lit from the
/// upper left. It goes straight on to `rim`, m, over the rounded lip, which the strip has not.
/// `pixels`: of a metre. Allocates.
view::Image side_view(const view::Image& strip, std::span<const Vec2> outline, double rim,
                      double pixels);

/// Each zone on its cone, developed: a cone can be laid flat without stretching. Of a place on it
/// at the radius r, and `turn` of the way round (-0.5..0.5),
///   s = r / |dr|,  x = s sin(2 pi |dr| turn),  y = s cos(2 pi |dr| turn),
/// with dr the cone's widening for each metre along it; s is the distance from its tip. A cone that
/// hardly widens is a band. The foot's zone is below; all have one scale, `pixels` of a metre, and
/// stand `gap` m apart. Allocates; 0.2 s for a megapixel.
view::Image on_cones(const view::Image& strip, std::span<const Vec2> outline,
                     std::span<const Cone> cones, double pixels, double gap);

}  // namespace onggi::exhibit

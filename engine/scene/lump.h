#pragma once

#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"

namespace onggi {

/// Targets are worked at a size a hand can reach: the factor that brings `target` within
/// `max_height` and `max_diameter` (metres). Both > 0.
double workspace_scale(const Profile& target, double max_height = 0.20, double max_diameter = 0.22);

/// The lump a potter would weigh out for `target` (already at workspace scale) in `scene`, whose
/// clay gives all other fields: thick-walled, nowhere near the target's outline, and as tall as the
/// target; where the scene keeps volume, as tall as makes the target of it.
ClayDef lump_for(const Profile& target, const SceneDef& scene);

/// A ring of wall: its faces' radii, m.
struct WallRing {
  double outer = 0.0, inner = 0.0;
};
/// Presses from outside bring the outer face of `ring` to `outer` m, which is nearer to the axis,
/// or presses from inside the inner one to `inner`, which is farther: where the other face goes in
/// `scene`, to what the clay may be.
WallRing narrowed(const SceneDef& scene, const WallRing& ring, double outer);
WallRing widened(const SceneDef& scene, const WallRing& ring, double inner);
/// widened() so far that the outer face comes to `outer`, or narrowed().
WallRing worked(const SceneDef& scene, const WallRing& ring, double outer);

}  // namespace onggi

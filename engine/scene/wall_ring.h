#pragma once

#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// The radii of a ring of wall, m.
struct WallRing {
  double outer = 0.0, inner = 0.0;
};
/// Area over pi, m^2.
inline double area_of(const WallRing& ring) {
  return (ring.outer - ring.inner) * (ring.outer + ring.inner);
}

/// `ring` after presses that move its outer face to `outer` from outside (m, nearer the axis), or
/// its inner face to `inner` from inside (farther). The other face moves as in `scene`, within the
/// clay's limits.
WallRing narrowed(const SceneDef& scene, const WallRing& ring, double outer);
WallRing widened(const SceneDef& scene, const WallRing& ring, double inner);
/// Widens or narrows the ring until its outer face is at `outer`.
WallRing worked(const SceneDef& scene, const WallRing& ring, double outer);

}  // namespace onggi::scene

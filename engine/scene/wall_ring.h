#pragma once

#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// A ring of wall: its faces' radii, m.
struct WallRing {
  double outer = 0.0, inner = 0.0;
};
/// Of its clay, over pi, m^2.
inline double area_of(const WallRing& ring) {
  return (ring.outer - ring.inner) * (ring.outer + ring.inner);
}

/// Presses from outside bring the outer face of `ring` to `outer` m, which is nearer to the axis,
/// or presses from inside the inner one to `inner`, which is farther: where the other face goes in
/// `scene`, to what the clay may be.
WallRing narrowed(const SceneDef& scene, const WallRing& ring, double outer);
WallRing widened(const SceneDef& scene, const WallRing& ring, double inner);
/// widened() so far that the outer face comes to `outer`, or narrowed().
WallRing worked(const SceneDef& scene, const WallRing& ring, double outer);

}  // namespace onggi::scene

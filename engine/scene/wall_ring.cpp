#include "engine/scene/wall_ring.h"

#include <algorithm>
#include <cmath>

namespace onggi::scene {

WallRing narrowed(const SceneDef& scene, const WallRing& ring, double outer) {
  const ClayDef& clay = scene.clay;
  const double most = outer - clay.wall_min;
  // Walls keep a ring's area. Without them the inner face stays until the wall is thin.
  const double inner =
      scene.walls ? std::sqrt(std::max(outer * outer - area_of(ring), 0.0)) : ring.inner;
  return {outer, std::max(std::min(inner, most), std::min(clay.radius_min, ring.inner))};
}

WallRing widened(const SceneDef& scene, const WallRing& ring, double inner) {
  const double least = inner + scene.clay.wall_min;
  const double outer = scene.walls ? std::sqrt(inner * inner + area_of(ring)) : ring.outer;
  return {std::max(outer, least), inner};
}

WallRing worked(const SceneDef& scene, const WallRing& ring, double outer) {
  if (outer <= ring.outer) return narrowed(scene, ring, outer);
  const double thin = outer - scene.clay.wall_min;
  const double inner =
      scene.walls ? std::min(std::sqrt(outer * outer - area_of(ring)), thin) : thin;
  return {outer, inner};
}

}  // namespace onggi::scene

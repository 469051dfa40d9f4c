#pragma once

#include "engine/base/result.h"
#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"

namespace onggi {

/// What a jar is to measure, metres and m^3.
struct JarWish {
  double volume = 0.001;                         ///< That it holds, filled to its rim.
  double height_least = 0.0, height_most = 0.2;  ///< From the standing surface to the rim.
  double mouth_least = 0.0, mouth_most = 0.22;   ///< Outer diameter at the rim.
};

/// A plain jar with a belly that measures so, as hands can make it of the lump that `scene` would
/// lay for it (lump_for): its wall is as thick as the ring's clay makes it there. One of many that
/// answer the wish. Within 0.1 % of the volume. Problem: no such jar is at once so large or small,
/// within the bounds, and no more than 0.2 m high and 0.22 m wide. Deterministic; allocates.
Result<Profile> jar_that_holds(const JarWish& wish, const SceneDef& scene);

}  // namespace onggi

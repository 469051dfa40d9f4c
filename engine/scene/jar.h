#pragma once

#include "engine/base/result.h"
#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"

namespace onggi {

/// Wanted measures of a jar, metres and m^3.
struct JarWish {
  double volume = 0.001;                         ///< Capacity when filled to the rim.
  double height_least = 0.0, height_most = 0.2;  ///< From the standing surface to the rim.
  double mouth_least = 0.0, mouth_most = 0.22;   ///< Outer diameter at the rim.
};

/// A plain jar with a belly that has these measures, and that hands can make from the lump that
/// `scene` lays for it (lump_for). Its wall is as thick as that clay allows. One of many solutions,
/// within 0.1 % of the volume. Problem if no such jar exists within the bounds, 0.2 m high and 0.22
/// m wide. Deterministic; allocates.
Result<Profile> jar_that_holds(const JarWish& wish, const SceneDef& scene);

}  // namespace onggi

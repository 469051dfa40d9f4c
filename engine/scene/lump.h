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

}  // namespace onggi

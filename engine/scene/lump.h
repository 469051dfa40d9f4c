#pragma once

#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"

namespace onggi {

namespace scene {
/// A target stands at most so high on the wheel, m.
inline constexpr double kTallestTarget = 0.20;
/// Height of the floor on which a pot is built of coils, m: 10 mm, and at least floor_min.
double built_floor(const ClayDef& clay);
}  // namespace scene

/// The factor that brings `target` within `max_height` and `max_diameter` (metres), so that a hand
/// can reach all of it. Both > 0.
double workspace_scale(const Profile& target, double max_height = scene::kTallestTarget,
                       double max_diameter = 0.22);

/// The lump for `target` (already at workspace scale). All other fields come from `scene`'s clay.
/// It is thick-walled, away from the target's outline, and as tall as the target; if the scene
/// keeps volume, as tall as the target's clay needs. If the scene has coils (BuildingDef), it is a
/// floor to build on: a disc of scene::built_floor() as wide as the target is halfway up it, with
/// rows as high as the scene's.
ClayDef lump_for(const Profile& target, const SceneDef& scene);

}  // namespace onggi

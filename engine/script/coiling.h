#pragma once

#include "engine/profile/profile.h"
#include "engine/script/plan.h"

namespace onggi::script {

/// The script that lays rings of coil on the rim, one on the other, on a slow wheel: the hand holds
/// still over the middle of the rim until a ring must be closed, and goes up for the next. Without
/// BuildingDef the hands do the same moves. Allocates; not for the tick.
Plan lay_rings;
/// The same up a vessel's line, as many as its height asks for, on a faster wheel.
Plan build_up;

/// Whether rings of a coil of `coil` m come near the outline of `target` (m): a ring leans out or
/// in by at most 0.45 coils, so they follow neither a wide shoulder nor a bowl. Near: the mean
/// distance (RMS) of the outline is below 0.018 of the height. Real rings drift outwards, and come
/// to twice that at most. Pure.
bool coils_come_near(const Profile& target, double coil);

}  // namespace onggi::script

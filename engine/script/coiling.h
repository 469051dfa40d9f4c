#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

/// The script that lays rings of coil on the rim, one on the other, on a slow wheel: the hand holds
/// still over the middle of the rim until a ring must be closed, and goes up for the next. Without
/// BuildingDef the hands do the same moves. Allocates; not for the tick.
Plan lay_rings;
/// The same up a vessel's line, as many as its height asks for, on a faster wheel.
Plan build_up;

}  // namespace onggi::script

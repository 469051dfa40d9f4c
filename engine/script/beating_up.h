#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

/// The script that beats the wall between paddle and anvil, from the foot to the rim, on a slow
/// wheel. Without BeatingDef the hands do the same moves. Allocates; not for the tick.
Plan beat_wall;

}  // namespace onggi::script

#pragma once

#include <string_view>

#include "engine/scene/scene_def.h"
#include "engine/script/choreography.h"

namespace onggi {

/// Plans the moves that work on the top and the floor of a pot, or on both faces of its wall:
/// "open", "press_rim", "flare_rim", "squeeze". Allocates; not for the tick.
void work_upright(std::string_view name, Choreography& hand, const SceneDef& scene);

}  // namespace onggi

#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

class Thrower;

/// Moves that show a scene's effects: a wall pulled up between two hands, a wall that falls, clay
/// that dries and is wetted again, a lump that wobbles, a line under a rib. Without the effect the
/// hands do the same moves. Allocate; not for the tick.
using Throwing = void(Thrower& hand);
Throwing pull_four_times, pull_and_drown, press_wet_and_drier, press_and_wet_again;
Throwing press_steadily, draw_and_even;

/// The script of these moves.
std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool, Throwing& moves);

}  // namespace onggi::script

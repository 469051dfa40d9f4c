#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

class Choreography;
class Former;

/// Moves of fingers that give a lump a shape: former.h plans the passes; upright.h has the moves on
/// the top, the floor and both faces. Allocate; not for the tick.
using Forming = void(Choreography& hand, Former& former, const SceneDef& scene);
Forming turn_true, narrow_neck, push_barrel, flare_wall, hold_finger;

/// The script of these moves.
std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool, Forming& moves);
/// The script that brings the clay to the target's outline.
Plan follow;

}  // namespace onggi::script

#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

class Choreography;
class Former;

/// Finger moves that shape a lump: former.h plans the passes; upright.h has moves on top, floor and
/// both faces. Allocate; not for the tick.
using Forming = void(Choreography& hand, Former& former, const SceneDef& scene);
Forming turn_true, narrow_neck, push_barrel, flare_wall, hold_finger;

/// The script of these moves.
std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand& tool, Forming& moves);
/// The script that brings the clay to the target's outline.
Plan follow;

}  // namespace onggi::script

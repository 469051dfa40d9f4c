#pragma once

#include "engine/scene/scene_def.h"
#include "engine/script/choreography.h"

namespace onggi::script {

class Former;

/// Moves on the top and the floor of a pot, or on both faces of its wall, which need no account of
/// the shape. Allocate; not for the tick.
///
/// A fingertip down the middle, out along the floor, and up the wall.
void open_up(Choreography& hand, Former&, const SceneDef& scene);
/// A fingertip laid on the lip and pressed down a twentieth of the pot's height.
void press_lip(Choreography& hand, Former&, const SceneDef& scene);
/// A fingertip over the lip's inner edge, drawn outwards.
void flare_lip(Choreography& hand, Former&, const SceneDef& scene);
/// A hand outside and one inside take a third off the wall and draw up it.
void squeeze_wall(Choreography& hand, Former&, const SceneDef& scene);

}  // namespace onggi::script

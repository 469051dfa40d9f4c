#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

/// Fingers give a lump a shape: former.h plans the passes, upright.h the moves on the top, the
/// floor and both faces. "true" is true_up.
Plan true_up, collar, belly, bowl, groove, follow;
Plan open, press_rim, flare_rim, squeeze;

}  // namespace onggi::script

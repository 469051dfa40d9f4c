#include "engine/effects/row_stage.h"

#include <algorithm>

#include "engine/effects/effect_list.h"

namespace onggi::effects {

double StageWork::along(WallSide face) const noexcept {
  double along = def.walls ? 1.0 : 0.0;
  for (const HandThere& hand : tick.hand)
    if (hand.on_wall && hand.side == face) along = std::min(along, hand.along);
  return along;
}

}  // namespace onggi::effects

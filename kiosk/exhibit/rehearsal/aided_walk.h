#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::rehearsal {

/// A whole visit in the real program by somebody who hears and has keys (blind), or sees and has
/// one switch: see aided_visitor.h.
struct AidedWalk {
  bool blind = true;
  int card = 0;           ///< Of the shelf.
  int mission = -1;       ///< Instead, of those that are on.
  int glaze = 0;          ///< Of the exhibit's, where the scene has a kiln.
  int strokes = 24;       ///< After which the pot is called done, if it is not close before.
  bool realtime = false;  ///< At a visitor's speed.
};

/// Frames until the visitor is back at attract with the keepsake safe. `passed(name)` when a screen
/// is worth a picture, once a name. Gives all that was said. Problem where there is no way on.
Result<std::vector<access::Utterance>> walk_aided(
    exhibit::Kiosk& kiosk, const AidedWalk& how,
    const std::function<void(const std::string&)>& passed);

}  // namespace onggi::rehearsal

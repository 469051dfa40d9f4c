#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/visit/access/utterance.h"

namespace onggi::rehearsal {

/// A whole visit in the real program by a visitor who hears and has keys (blind), or who sees and
/// has one switch: see aided_visitor.h.
struct AidedWalk {
  bool blind = true;
  int card = 0;           ///< On the shelf.
  int mission = -1;       ///< Instead of a card: index among the missions that are on.
  int glaze = 0;          ///< Index in the exhibit's glazes, if the scene has a kiln.
  int strokes = 24;       ///< The pot is called done after this many, or earlier if it is close.
  bool realtime = false;  ///< At a real visitor's speed.
};

/// Runs frames until the visitor is back at attract and the keepsake is saved. Calls `passed(name)`
/// once for each screen worth a picture. Returns all spoken texts. Problem if the visitor is stuck.
Result<std::vector<access::Utterance>> walk_aided(
    exhibit::Kiosk& kiosk, const AidedWalk& how,
    const std::function<void(const std::string&)>& passed);

}  // namespace onggi::rehearsal

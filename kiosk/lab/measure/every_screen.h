#pragma once

#include <functional>
#include <string>

#include "kiosk/exhibit/composition/kiosk.h"

namespace onggi::measure {

/// Called at every state that a visitor can see, the kiosk standing still in it: "throw",
/// "throw drawer". A Problem ends the walk.
using LookAtScreen = std::function<Result<void>(const std::string& state)>;

/// Goes through a stepped `kiosk` as a visitor who looks at everything: attract until a vessel is
/// named, the shelf and a label, Comfort, Help, the wheel with a pot half thrown by script and its
/// drawer, the result, the kiln, the keepsake, the gallery of what was kept, the question whether
/// somebody is there, and a fault. Of the shelf it is the vessel of `card`. Problem where a control
/// is missing.
Result<void> look_at_every_screen(exhibit::Kiosk& kiosk, int card, const LookAtScreen& look);

/// Likewise through what only missions have, of a kiosk on which they are on: the shelf with all of
/// them, and of each the offer, the wheel with a pot half thrown by script, where it differs its
/// drawers, and the result; with eyes closed also what lies over the dark; of a description the
/// keepsake and the gallery. Problem where none is on.
Result<void> look_at_every_mission(exhibit::Kiosk& kiosk, const LookAtScreen& look);

}  // namespace onggi::measure

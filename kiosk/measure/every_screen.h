#pragma once

#include <functional>
#include <string>

#include "kiosk/exhibit/kiosk.h"

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

}  // namespace onggi::measure

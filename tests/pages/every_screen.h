#pragma once

#include <functional>
#include <string>

#include "kiosk/exhibit/composition/kiosk.h"

namespace onggi::pages {

/// Called at every state that a visitor can see, with the kiosk standing still: "throw", "throw
/// drawer". A Problem ends the walk.
using LookAtScreen = std::function<Result<void>(const std::string& state)>;

/// Goes through a stepped `kiosk` like a visitor who looks at everything: attract until a vessel is
/// named, the shelf and a label, Comfort, Help, the wheel with a half-thrown pot and its drawer,
/// the result, the kiln, the keepsake, the gallery, the idle warning, and a fault. Uses the vessel
/// of `card`. Problem if a control is missing.
Result<void> look_at_every_screen(exhibit::Kiosk& kiosk, int card, const LookAtScreen& look);

/// The same for the screens of missions, on a kiosk where they are on: the shelf with all of them,
/// and for each the offer, the wheel with a half-thrown pot, its drawers if they differ, and the
/// result; with eyes closed also what lies over the dark screen; for a description the keepsake and
/// the gallery. Problem if none is on.
Result<void> look_at_every_mission(exhibit::Kiosk& kiosk, const LookAtScreen& look);

}  // namespace onggi::pages

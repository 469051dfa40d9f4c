#pragma once

#include "engine/profile/profile.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/files/json.h"

namespace onggi::commands {

/// "measured", "inferred", "none".
const char* name_of(InnerWall wall);

/// What was read from a vessel's file: its profile, and how far that can be believed. Lengths in
/// metres. Allocates.
files::Json vessel_json(const content::Vessel& vessel);

}  // namespace onggi::commands

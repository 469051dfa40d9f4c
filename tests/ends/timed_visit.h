#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "kiosk/ground/files/json.h"

namespace onggi::ends {

struct VisitPlan {
  std::filesystem::path config, keepsakes;
  int mission = -1;  ///< Among those that are on; below 0: a vessel.
};

/// Opens the exhibit with its 1 kHz loop, as a service that systemd watches (STATE_DIRECTORY and
/// NOTIFY_SOCKET as systemd sets them), and lets a naive visitor make a whole visit, with the
/// screens' clock six times as fast. Needs a display. Main thread.
/// {ended, why, frames, open: {processor_s, wall_s}, close: ..., frame: {processor_s, wall_s, at},
/// slow: [...]}: the time of the frame's thread that opening and closing took, its longest frame,
/// and every frame over 0.25 s. `why`: what kept the visit from its end.
files::Json timed_visit(const VisitPlan& plan);

}  // namespace onggi::ends

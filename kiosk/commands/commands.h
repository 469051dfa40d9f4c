#pragma once

#include "kiosk/commands/command.h"

namespace onggi::commands {

/// The program: it opens the exhibit, and has all the others.
Command onggi_command();

Command run_command();
Command visit_command();
Command replay_command();
Command check_command();
Command vessel_command();
Command score_command();
Command soak_command();
Command stats_command();
Command report_command();
Command lab_command();
Command devices_command();
Command setup_command();

/// Of `onggi lab`.
Command lab_access_command();
Command lab_loop_command();
Command lab_frames_command();
Command lab_sound_command();
Command lab_screens_command();
Command lab_naive_command();
Command lab_scenes_command();

/// Of `onggi vessel`.
Command make_command();
Command inspect_command();
Command import_command();

/// Of `onggi lab`.
Command accuracy_command();
Command tune_command();

}  // namespace onggi::commands

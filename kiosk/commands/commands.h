#pragma once

#include "kiosk/cli/command.h"

namespace onggi::commands {

/// The program: it opens the exhibit, and has all the others.
cli::Command onggi_command();

cli::Command run_command();
cli::Command visit_command();
cli::Command replay_command();
cli::Command check_command();
cli::Command vessel_command();
cli::Command score_command();
cli::Command soak_command();
cli::Command stats_command();
cli::Command report_command();
cli::Command lab_command();
cli::Command devices_command();
cli::Command setup_command();

/// Of `onggi lab`.
cli::Command lab_access_command();
cli::Command lab_loop_command();
cli::Command lab_frames_command();
cli::Command lab_sound_command();
cli::Command lab_screens_command();
cli::Command lab_naive_command();
cli::Command lab_scenes_command();

/// Of `onggi vessel`.
cli::Command make_command();
cli::Command inspect_command();
cli::Command import_command();

/// Of `onggi lab`.
cli::Command accuracy_command();
cli::Command tune_command();

}  // namespace onggi::commands

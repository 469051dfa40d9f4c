#pragma once

#include "kiosk/ground/cli/command.h"

namespace onggi::laboratory {

/// The program onggi-lab with all commands below.
cli::Command lab_command();

cli::Command accuracy_command();
cli::Command lab_access_command();
cli::Command lab_frames_command();
cli::Command lab_loop_command();
cli::Command lab_scenes_command();
cli::Command lab_sound_command();
cli::Command lab_witness_command();
cli::Command soak_command();

}  // namespace onggi::laboratory

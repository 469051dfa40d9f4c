#pragma once

#include "kiosk/ground/cli/command.h"

namespace onggi::commands {

/// The program: it opens the exhibit, and contains all other commands.
cli::Command onggi_command();

cli::Command run_command();
cli::Command visit_command();
cli::Command replay_command();
cli::Command check_command();
cli::Command set_command();
cli::Command undo_command();
cli::Command vessel_command();
cli::Command score_command();
cli::Command stats_command();
cli::Command poster_command();
cli::Command screen_command();
cli::Command keepsake_command();
cli::Command report_command();
cli::Command devices_command();
cli::Command setup_command();

/// Subcommands of `onggi vessel`.
cli::Command make_command();
cli::Command inspect_command();
cli::Command import_command();
cli::Command look_command();
cli::Command decorate_command();

/// Subcommands of `onggi lab`, in the museum's program.
cli::Command tune_command();
cli::Command prices_command();

}  // namespace onggi::commands

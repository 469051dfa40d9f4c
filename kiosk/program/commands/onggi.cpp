#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {
/// The part of the laboratory that a museum needs. Other commands are in onggi-lab (lab_program.h).
cli::Command lab_command() {
  return {.name = "lab",
          .help = "Measure this machine (all but tune and prices need the package onggi-lab)",
          .examples =
              "Example: onggi lab tune --write config/scenes/first_touch.toml\n"
              "         onggi lab prices config/scenes/studio.toml\n"
              "         onggi lab accuracy\n"
              "onggi-lab --help lists the commands of the package onggi-lab.",
          .commands = {tune_command(), prices_command()}};
}
}  // namespace

cli::Command onggi_command() {
  // The same options with and without the word "run", because a kiosk is started by its bare name.
  const cli::Command run = run_command();
  return {.name = "onggi",
          .help = "Onggi: throw pots on a virtual wheel, in a museum.",
          .examples =
              "Example: onggi --window 1280x720\n"
              "Without a command the exhibit opens, as with: onggi run\n"
              "Exit: 0 success, 1 a fault of the program or machine, 2 a mistake in the input.",
          .options = run.options,
          .commands = {run, visit_command(), replay_command(), check_command(), set_command(),
                       undo_command(), vessel_command(), score_command(), stats_command(),
                       keepsake_command(), screen_command(), poster_command(), report_command(),
                       lab_command(), devices_command(), setup_command()},
          .run = run.run};
}

}  // namespace onggi::commands

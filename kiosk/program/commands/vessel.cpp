#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

cli::Command vessel_command() {
  return {
      .name = "vessel",
      .help = "Make a vessel from a drawing, decorate or measure one, or put a scan on the shelf",
      .examples = "Example: onggi vessel make content/vessels/moon_jar/profile.toml -o vessel.glb",
      .commands = {make_command(), decorate_command(), inspect_command(), look_command(),
                   import_command()}};
}

}  // namespace onggi::commands

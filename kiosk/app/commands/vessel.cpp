#include <iostream>
#include <memory>
#include <string>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/log.h"
#include "kiosk/content/drawing.h"
#include "kiosk/content/model.h"
#include "kiosk/files/durable_file.h"

namespace onggi::app {

namespace {

Result<void> make(const std::string& drawing_file, const std::string& out) {
  const auto drawing = content::read_drawing(drawing_file);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto glb = content::make_glb(*drawing);
  if (auto good = files::write_durably(out, glb); !good) return good;
  std::cout << out << ": " << drawing->title << ", " << glb.size() / 1024 << " kB\n";
  return {};
}

}  // namespace

void add_vessel(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::string drawing, out = "vessel.glb";
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "vessel", "Make a vessel from a drawing, look into one, or put a scan on the shelf");
  command->require_subcommand(1);
  command->footer("Example: onggi vessel make content/vessels/moon_jar/profile.toml -o vessel.glb");

  CLI::App* maker = command->add_subcommand("make", "Turn a drawn profile into a GLB");
  maker->footer("Example: onggi vessel make profile.toml -o vessel.glb");
  maker->add_option("drawing", arguments->drawing, "The drawing's TOML (kiosk/docs/curators.md)")
      ->required();
  maker->add_option("-o,--out", arguments->out, "The GLB to write [vessel.glb]");
  maker->callback([arguments, &exit_code] {
    if (auto good = make(arguments->drawing, arguments->out); !good)
      exit_code = exit_with(good.error());
  });

  add_inspect(*command, exit_code);
  add_import(*command, exit_code);
}

}  // namespace onggi::app

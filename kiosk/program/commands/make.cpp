#include <iostream>
#include <memory>

#include "engine/base/plain_text.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/model.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct MakeArguments {
  std::string drawing;
  files::Output out{files::Output::Kind::glb, "vessel.glb"};
};

Result<int> make(const MakeArguments& arguments) {
  const auto drawing = content::read_drawing(arguments.drawing);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto glb = content::make_glb(*drawing);
  if (auto good = arguments.out.write(glb); !good) return tl::unexpected(good.error());
  if (arguments.out.to_stdout()) return 0;
  std::cout << terminal::plain(arguments.out.where()) << ": " << terminal::plain(drawing->title)
            << ", " << glb.size() / 1024 << " kB\n";
  return 0;
}

}  // namespace

cli::Command make_command() {
  const auto a = std::make_shared<MakeArguments>();
  return {
      .name = "make",
      .help = "Turn a drawn profile into a GLB",
      .examples = "Example: onggi vessel make profile.toml -o vessel.glb",
      .options = {{.name = "drawing",
                   .field = &a->drawing,
                   .help = "The drawing's TOML (kiosk/docs/draw_a_vessel.md)",
                   .required = true},
                  {"-o,--out", &a->out, "The GLB to write (- for standard output) [vessel.glb]"}},
      .run = [a] { return make(*a); }};
}

}  // namespace onggi::commands

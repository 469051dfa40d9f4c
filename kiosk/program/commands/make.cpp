#include <iostream>
#include <memory>

#include "engine/base/plain_text.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/model.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct MakeArguments {
  std::string drawing, decoration;
  files::Output out{files::Output::Kind::glb, "vessel.glb"};
};

using Bytes = std::vector<std::byte>;

Result<Bytes> decorated_glb(const content::Drawing& drawing, const std::string& file) {
  const auto decoration = decoration::read_decoration(file);
  if (!decoration) return tl::unexpected(decoration.error());
  const auto surface = content::decorated(drawing, *decoration, file);
  if (!surface) return tl::unexpected(surface.error());
  decoration::Unrolled colors = decoration::unrolled(*surface, *decoration);
  const auto png = encoding::encode({colors.width, colors.height, std::move(colors.rgba)},
                                    encoding::Format::png, {drawing.title, "", ""});
  if (!png) return tl::unexpected(png.error());
  decoration::Skin skin = decoration::placed(content::turned(drawing), drawing.section, *surface);
  return content::make_glb(drawing, skin.mesh, {std::move(skin.places), *png});
}

Result<int> make(const MakeArguments& arguments) {
  const auto drawing = content::read_drawing(arguments.drawing);
  if (!drawing) return tl::unexpected(drawing.error());
  const Result<Bytes> made = arguments.decoration.empty()
                                 ? Result<Bytes>(content::make_glb(*drawing))
                                 : decorated_glb(*drawing, arguments.decoration);
  if (!made) return tl::unexpected(made.error());
  const Bytes& glb = *made;
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
      .examples =
          "Example: onggi vessel make profile.toml -o vessel.glb\n"
          "         onggi vessel make profile.toml --decoration decoration.toml -o vessel.glb",
      .options = {{.name = "drawing",
                   .field = &a->drawing,
                   .help = "The drawing's TOML (kiosk/docs/draw_a_vessel.md)",
                   .required = true},
                  {"--decoration", &a->decoration,
                   "How it was decorated: a TOML (kiosk/docs/decorate_a_vessel.md)"},
                  {"-o,--out", &a->out, "The GLB to write (- for standard output) [vessel.glb]"}},
      .run = [a] { return make(*a); }};
}

}  // namespace onggi::commands

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "engine/profile/measures.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/drawing/sheet_painter.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/up_option.h"
#include "kiosk/program/commands/vessel_json.h"

namespace onggi::commands {

namespace {

struct InspectArguments {
  std::string file, node, up;
  files::Output json{files::Output::Kind::json};
  files::Output plot{files::Output::Kind::png};
};

void print_summary(const content::Vessel& vessel) {
  using terminal::plain;
  const ExtractedProfile& e = vessel.extracted;
  const Dimensions d = dimensions(e.profile);
  std::printf(
      "%s\n  height %.1f mm, widest %.1f mm at %.1f mm, mouth %.1f mm, foot %.1f mm\n"
      "  wall %.1f mm (%s), symmetry %.3f, %.1f %% masked\n",
      plain(vessel.file.string()).c_str(), d.height * 1e3, d.belly * 1e3, d.belly_height * 1e3,
      d.mouth * 1e3, d.foot * 1e3, d.wall_mean * 1e3, name_of(e.profile.inner_wall), e.symmetry,
      e.masked_fraction * 100);
  if (!vessel.credit.empty() || !vessel.licence.empty())
    std::printf("  %s%s%s\n", plain(vessel.credit).c_str(),
                vessel.credit.empty() || vessel.licence.empty() ? "" : ", ",
                plain(vessel.licence).c_str());
  if (vessel.nodes.size() > 1) {
    std::printf("  of %zu objects:", vessel.nodes.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(vessel.nodes.size(), 8); ++i)
      std::printf("%s \"%s\"", i == 0 ? "" : ",", plain(vessel.nodes[i].name).c_str());
    std::printf("%s; --node NAME reads one alone\n", vessel.nodes.size() > 8 ? " ..." : "");
  }
  for (const std::string& warning : e.warnings) std::printf("  note: %s\n", plain(warning).c_str());
}

Result<void> plot(const content::Vessel& vessel, const files::Output& output) {
  const drawing::VesselSheet sheet = drawing::sheet_of(vessel);
  encoding::Caption caption;
  caption.title = sheet.title;
  caption.copyright = sheet.credit;
  caption.description = "Section and view, drawn by Onggi from " + vessel.file.filename().string();
  const auto png = encoding::encode(drawing::draw_sheet(sheet), encoding::Format::png, caption);
  if (!png) return tl::unexpected(png.error());
  return output.write(*png);
}

Result<int> inspect(const InspectArguments& arguments) {
  content::LoadOptions options;
  options.node = arguments.node;
  if (auto good = take_up(arguments.up, options); !good) return tl::unexpected(good.error());
  const auto vessel = content::load_vessel(arguments.file, options);
  if (!vessel) return tl::unexpected(vessel.error());
  if (arguments.plot.wanted())
    if (auto good = plot(*vessel, arguments.plot); !good) return tl::unexpected(good.error());
  const auto free = drawing::put_report(vessel_json(*vessel), arguments.json);
  if (!free) return tl::unexpected(free.error());
  if (*free && !arguments.plot.to_stdout()) print_summary(*vessel);
  return 0;
}

}  // namespace

cli::Command inspect_command() {
  const auto a = std::make_shared<InspectArguments>();
  return {
      .name = "inspect",
      .help = "Measure a vessel as a target",
      .examples =
          "Example: onggi vessel inspect scan.glb --plot scan.png\n"
          "If the file cannot be a target, the exit status is 2 and the reason is printed.",
      .options = {{.name = "file",
                   .field = &a->file,
                   .help = "A GLB, glTF, OBJ, PLY or STL, a IIIF manifest or Smithsonian document "
                           "beside one, or a vessel pack",
                   .required = true},
                  {"--node", &a->node,
                   "The node that is the vessel, by name or number; NAME/* includes what "
                   "hangs on it [the whole file]"},
                  up_option(a->up),
                  {"--json", &a->json, "Write everything as JSON (- for standard output)"},
                  {"--plot", &a->plot,
                   "Draw section and view, as archaeologists do, into this PNG"}},
      .run = [a] { return inspect(*a); }};
}

}  // namespace onggi::commands

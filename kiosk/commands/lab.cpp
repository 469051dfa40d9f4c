#include <cstdio>
#include <memory>
#include <string>

#include "kiosk/commands/commands.h"
#include "kiosk/commands/put_report.h"
#include "kiosk/files/durable_file.h"
#include "kiosk/measure/price_list.h"

namespace onggi::commands {

namespace {

constexpr int kPasses = 3;

struct LabArguments {
  std::string json, plot, count, grid = "400x360";
  bool quick = false;
};

Result<int> effects(const LabArguments& arguments) {
  int rows = 0, sectors = 0;
  char rest = 0;
  if (std::sscanf(arguments.grid.c_str(), "%dx%d%c", &rows, &sectors, &rest) != 2)
    return problem("--grid", "It is not ROWSxSECTORS.", "Write 400x360.");
  const auto scenes = measure::scenes_with_presets(rows, sectors);
  if (!scenes) return tl::unexpected(scenes.error());
  if (!arguments.count.empty()) {
    for (const measure::PricedScene& scene : *scenes)
      if (scene.name == arguments.count)
        return measure::play_priced_ticks(scene).map([] { return 0; });
    return problem("--count", "There is no scene of that name.",
                   "Choose one that onggi lab effects lists.");
  }
  const auto list =
      measure::measure_prices(*scenes, rows, sectors, arguments.quick ? 1 : kPasses,
                              !arguments.quick, arguments.json == "-" ? stderr : stdout);
  if (!list) return tl::unexpected(list.error());
  if (const auto put = put_report(measure::json_of(*list), arguments.json); !put)
    return tl::unexpected(put.error());
  if (arguments.plot.empty()) return 0;
  return files::write_durably(arguments.plot,
                              drawing::draw_plot(measure::plot_of(*list), arguments.plot))
      .map([] { return 0; });
}

Command effects_command() {
  const auto a = std::make_shared<LabArguments>();
  return {.name = "effects",
          .help = "The price list: what each effect and each scene costs",
          .examples =
              "Example: onggi lab effects --json prices.json --plot prices.png\n"
              "Bytes are those beyond the base scene's. Instructions are of a tick, under "
              "valgrind.",
          .options =
              {{"--json", &a->json, "Write the list as JSON (- for standard output)"},
               {"--plot", &a->plot, "Draw it into this PNG or SVG"},
               {.name = "--grid", .field = &a->grid, .help = "ROWSxSECTORS", .shows_default = true},
               {"--quick", &a->quick, "Count no instructions"},
               {.name = "--count", .field = &a->count, .help = "", .hidden = true}},
          .run = [a] { return effects(*a); }};
}

}  // namespace

Command lab_command() {
  return {.name = "lab",
          .help = "Measure the engine on this machine",
          .examples = "Example: onggi lab effects",
          .commands = {effects_command()}};
}

}  // namespace onggi::commands

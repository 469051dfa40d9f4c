#include <cstdio>
#include <memory>
#include <string>

#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/force_loop.h"
#include "kiosk/picture/drawing/put_report.h"

namespace onggi::laboratory {

namespace {

struct LoopArguments {
  files::Output json{files::Output::Kind::json};
  files::Output plot{files::Output::Kind::picture};
  std::string write;
};

Result<int> write_limit(const std::string& file) {
  const auto limit = measure::write_stiffness_limit(file);
  if (!limit) return tl::unexpected(limit.error());
  std::printf(
      "%s: stiffness_limit %.1f N/m. The clay's stiffest, the wheel head, is about 500 N/m under "
      "half a newton, so it is %s.\nIts loop is stable up to %.0f and passive up to %.0f N/m "
      "(100000: any), by theory to %.0f; its encoder is not felt up to %.0f.\n",
      file.c_str(), limit->allowed, limit->allowed < 500.0 ? "felt softer" : "felt as it is",
      limit->stable, limit->passive, limit->colgate, limit->quiet);
  return 0;
}

Result<int> loop(const LoopArguments& arguments) {
  if (!arguments.write.empty()) return write_limit(arguments.write);
  const auto report = measure::measure_force_loop(stderr);
  if (!report) return tl::unexpected(report.error());
  return drawing::put_report(measure::json_of(*report), measure::text_of(*report),
                             measure::plot_of(*report), arguments.json, arguments.plot)
      .map([&report] { return report->good() ? 0 : 1; });
}

}  // namespace

cli::Command lab_loop_command() {
  const auto a = std::make_shared<LoopArguments>();
  return {.name = "loop",
          .help = "Measure how stiff a force a device can render, in a closed loop with the hand",
          .examples =
              "Example: onggi lab loop --json loop.json --plot loop.svg\n"
              "         onggi lab loop --write config/devices/onggi_hid.toml\n"
              "Exit: 0 if every device is stable and passive with a margin of 1.5, 1 if not.",
          .options = {{"--json", &a->json, "Write every loop as JSON (- for standard output)"},
                      {"--plot", &a->plot, "Draw them into this PNG or SVG"},
                      {"--write", &a->write,
                       "Only derive the stiffness limit of the device in this file from its "
                       "[body], and write it there"}},
          .run = [a] { return loop(*a); }};
}

}  // namespace onggi::laboratory

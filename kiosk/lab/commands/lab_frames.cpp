#include <cstdio>
#include <memory>
#include <string>

#include "kiosk/ground/files/paths.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/frame_rate.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/render/window_size.h"

namespace onggi::laboratory {

namespace {

struct FramesArguments {
  std::string config, size;
  files::Output json{files::Output::Kind::json}, plot{files::Output::Kind::picture};
  measure::FrameRatePlan plan;
};

Result<int> frames(FramesArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  arguments.plan.config = *config;
  if (!arguments.size.empty()) {
    render::WindowOptions window;
    if (auto good = render::read_window_size(arguments.size, window); !good)
      return tl::unexpected(good.error());
    arguments.plan.sizes = {{window.width, window.height}};
  }
  if (arguments.plan.only_loads && arguments.plot.wanted())
    return problem("--plot", "--plot draws times, but --counts measures none.",
                   "Remove one of the two, or write the counts with --json.");
  const auto report = measure::measure_frames(arguments.plan, stderr);
  if (!report) return tl::unexpected(report.error());
  return drawing::put_report(measure::json_of(*report), measure::text_of(*report),
                             measure::plot_of(*report), arguments.json, arguments.plot)
      .map([] { return 0; });
}

}  // namespace

cli::Command lab_frames_command() {
  const auto a = std::make_shared<FramesArguments>();
  return {.name = "frames",
          .help = "Measure frames per second, and how soon a drag is on the screen",
          .examples =
              "Example: onggi lab frames --json frames.json --plot frames.svg\n"
              "         onggi lab frames --size 1080x1920 --seconds 5",
          .options = {{"--size", &a->size, "Only this WIDTHxHEIGHT [1280x720, then 1920x1080]"},
                      {.name = "--seconds",
                       .field = &a->plan.seconds,
                       .help = "Seconds for each screen at each size [15]",
                       .least = 2.0,
                       .most = 600.0},
                      {"--counts", &a->plan.only_loads,
                       "Count only what a frame asks of the graphics, without times"},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"},
                      {"--plot", &a->plot, "Draw them into this PNG or SVG"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
          .run = [a] { return frames(*a); }};
}

}  // namespace onggi::laboratory

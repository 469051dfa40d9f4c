#include "kiosk/lab/measure/soak.h"

#include <memory>

#include "kiosk/ground/files/paths.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/soak_days.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/render/window_size.h"

namespace onggi::laboratory {

namespace {

struct SoakArguments {
  std::string config, window = "1280x720", out = "keepsakes/soak";
  measure::SoakPlan plan;
  double hours = 0;
  measure::SoakDaysPlan days;
  files::Output json{files::Output::Kind::json};
  files::Output plot{files::Output::Kind::picture};
};

Result<int> soak_days(SoakArguments& arguments) {
  arguments.days.config = arguments.plan.config;
  arguments.days.folder = arguments.plan.keepsakes;
  arguments.days.window = arguments.plan.window;
  arguments.days.hours = arguments.hours;
  for (const files::Output* out : {&arguments.json, &arguments.plot})
    if (auto good = out->check(); !good) return tl::unexpected(good.error());
  const auto report = measure::soak_days(arguments.days);
  if (!report) return tl::unexpected(report.error());
  return drawing::put_report(measure::json_of(*report), measure::text_of(*report),
                             measure::plot_of(*report), arguments.json, arguments.plot)
      .map([&report] { return report->good() ? 0 : 1; });
}

Result<int> soak(SoakArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  arguments.plan.config = *config;
  arguments.plan.keepsakes = arguments.out;
  if (auto good = render::read_window_size(arguments.window, arguments.plan.window); !good)
    return tl::unexpected(good.error());
  if (arguments.hours > 0) return soak_days(arguments);
  return measure::soak(arguments.plan);
}

}  // namespace

cli::Command soak_command() {
  const auto a = std::make_shared<SoakArguments>();
  return {.name = "soak",
          .help = "Run scripted visitors one after another, and watch memory and the 1 kHz loop",
          .examples =
              "Example: onggi lab soak --minutes 10 --window 1280x720\n"
              "         onggi lab soak --hours 72 --json soak.json --plot soak.svg\n"
              "With --hours the time between visits is skipped, and the troubles of an unattended "
              "kiosk "
              "\nhappen for real: helpers that die, a full disk, a folder that is "
              "gone, an exhibit\nthat is changed and broken. It changes only files in --out. "
              "Ten visits take a minute.\nExit: 0 if nothing was lost and nothing grew, else 1.",
          .options = {{.name = "--minutes",
                       .field = &a->plan.minutes,
                       .help = "Minutes to run [10]",
                       .least = 0.1,
                       .most = 1e5},
                      {.name = "--pace",
                       .field = &a->plan.pace,
                       .help = "Speed of the hands, 0.25 to 4 [3]",
                       .least = 0.25,
                       .most = 4.0},
                      {.name = "--hours",
                       .field = &a->hours,
                       .help = "Hours of the museum's clock, skipping the time between visits",
                       .least = 0.5,
                       .most = 1e4},
                      {.name = "--visits-an-hour",
                       .field = &a->days.visits_an_hour,
                       .help = "Seed, with --hours [6]",
                       .least = 0.5,
                       .most = 60.0},
                      {"--json", &a->json, "With --hours: write every quarter of an hour as JSON"},
                      {"--plot", &a->plot, "With --hours: draw them into this PNG or SVG"},
                      {"--script", &a->plan.script, "What the hands do [follow]"},
                      {"--by-device", &a->plan.by_device,
                       "Let a plugged-in device move the hand, not a script"},
                      {"--out", &a->out, "Folder for the keepsakes [keepsakes/soak]"},
                      {"--window", &a->window, "WIDTHxHEIGHT [1280x720]"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
          .run = [a] { return soak(*a); }};
}

}  // namespace onggi::laboratory

#include "kiosk/measure/soak.h"

#include <memory>

#include "kiosk/commands/commands.h"
#include "kiosk/commands/window_size.h"
#include "kiosk/exhibit/paths.h"

namespace onggi::commands {

namespace {

struct SoakArguments {
  std::string config, window = "1280x720", out = "keepsakes/soak";
  measure::SoakPlan plan;
};

Result<int> soak(SoakArguments& arguments) {
  const auto config = exhibit::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  arguments.plan.config = *config;
  arguments.plan.keepsakes = arguments.out;
  if (auto good = read_window_size(arguments.window, arguments.plan.window); !good)
    return tl::unexpected(good.error());
  return measure::soak(arguments.plan);
}

}  // namespace

Command soak_command() {
  const auto a = std::make_shared<SoakArguments>();
  return {.name = "soak",
          .help = "Let scripted visitors come and go, and watch memory and the 1 kHz loop",
          .examples = "Example: onggi soak --minutes 10 --window 1280x720",
          .options = {{.name = "--minutes",
                       .field = &a->plan.minutes,
                       .help = "How long [10]",
                       .least = 0.1,
                       .most = 1e5},
                      {.name = "--pace",
                       .field = &a->plan.pace,
                       .help = "Of the hands, 0.25 to 4 [3]",
                       .least = 0.25,
                       .most = 4.0},
                      {"--script", &a->plan.script, "What the hands do [follow]"},
                      {"--by-device", &a->plan.by_device,
                       "A device that is plugged in moves the hand, not a script"},
                      {"--out", &a->out, "Where its keepsakes go [keepsakes/soak]"},
                      {"--window", &a->window, "WIDTHxHEIGHT [1280x720]"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"}},
          .run = [a] { return soak(*a); }};
}

}  // namespace onggi::commands

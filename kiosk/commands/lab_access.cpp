#include <cstdio>
#include <memory>

#include "kiosk/commands/commands.h"
#include "kiosk/commands/put_report.h"
#include "kiosk/commands/window_size.h"
#include "kiosk/exhibit/paths.h"
#include "kiosk/files/virtual_display.h"
#include "kiosk/measure/access_report.h"
#include "kiosk/measure/no_keepsakes.h"

namespace onggi::commands {

namespace {

struct AccessArguments {
  files::Output json{files::Output::Kind::json};
  std::string config, window = "1920x1080", language;
};

Result<int> access(const AccessArguments& arguments) {
  const auto config = exhibit::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.language = arguments.language;
  if (auto good = read_window_size(arguments.window, options.window); !good)
    return tl::unexpected(good.error());
  const auto nowhere = measure::NoKeepsakes::make();
  if (!nowhere) return tl::unexpected(nowhere.error());
  options.keepsakes = nowhere->path();
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  const auto report = measure::measure_access(**opened);
  if (!report) return tl::unexpected(report.error());
  const auto put = put_report(measure::json_of(*report), arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put) std::fputs(measure::text_of(*report).c_str(), stdout);
  return 0;
}

}  // namespace

Command lab_access_command() {
  const auto a = std::make_shared<AccessArguments>();
  return {.name = "access",
          .help = "EN 301 549's figures of the exhibit, measured on its drawn screens",
          .examples = "Example: onggi lab access --window 1080x1920 --json access.json",
          .options = {{"--window", &a->window, "WIDTHxHEIGHT of the screens [1920x1080]"},
                      {"--language", &a->language, "A language of the exhibit [its first]"},
                      {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"},
                      {"--json", &a->json, "Write the figures as JSON (- for standard output)"}},
          .run = [a] { return access(*a); }};
}

}  // namespace onggi::commands

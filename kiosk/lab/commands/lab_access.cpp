#include <cstdio>
#include <memory>

#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/virtual_display.h"
#include "kiosk/lab/commands/lab_commands.h"
#include "kiosk/lab/measure/access_report.h"
#include "kiosk/lab/measure/measurement_folder.h"
#include "kiosk/picture/drawing/put_report.h"
#include "kiosk/picture/render/window_size.h"

namespace onggi::laboratory {

namespace {

struct AccessArguments {
  files::Output json{files::Output::Kind::json};
  std::string config, window = "1920x1080", language;
  bool displays = false;
};

Result<int> access(const AccessArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.stepped = true;
  options.devices = false;
  options.language = arguments.language;
  if (auto good = render::read_window_size(arguments.window, options.window); !good)
    return tl::unexpected(good.error());
  const auto nowhere = measure::MeasurementFolder::make();
  if (!nowhere) return tl::unexpected(nowhere.error());
  options.keepsakes = nowhere->path();
  auto display = files::VirtualDisplay::ensure(options.window.width, options.window.height);
  if (!display) return tl::unexpected(display.error());
  auto opened = exhibit::Kiosk::open(options);
  if (!opened) return tl::unexpected(opened.error());
  const bool all = arguments.displays;
  const auto reports = measure::measure_access(
      **opened, all ? measure::likely_displays() : std::vector<measure::AccessDisplay>{});
  if (!reports) return tl::unexpected(reports.error());
  files::Json json = measure::json_of(reports->front());
  if (all) {
    json["displays"] = files::Json::list();
    for (const auto& report : *reports) json["displays"].push_back(measure::json_of(report));
  }
  const auto put = drawing::put_report(json, arguments.json);
  if (!put) return tl::unexpected(put.error());
  if (*put) {
    std::fputs(measure::text_of(reports->front()).c_str(), stdout);
    if (all) std::fputs(("\n" + measure::table_of(*reports)).c_str(), stdout);
  }
  return 0;
}

}  // namespace

cli::Command lab_access_command() {
  const auto a = std::make_shared<AccessArguments>();
  return {
      .name = "access",
      .help = "Measure EN 301 549's figures on the exhibit's drawn screens",
      .examples =
          "Example: onggi lab access --window 1080x1920 --json access.json\n"
          "         onggi lab access --displays",
      .options = {{"--window", &a->window, "WIDTHxHEIGHT of the screens [1920x1080]"},
                  {"--language", &a->language, "A language of the exhibit [its first]"},
                  {"--displays", &a->displays, "Also measure common kiosk displays, one line each"},
                  {"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"},
                  {"--json", &a->json, "Write the figures as JSON (- for standard output)"}},
      .run = [a] { return access(*a); }};
}

}  // namespace onggi::laboratory

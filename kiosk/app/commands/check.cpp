#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "kiosk/app/check_exhibit.h"
#include "kiosk/app/commands/commands.h"
#include "kiosk/app/log.h"
#include "kiosk/app/paths.h"

namespace onggi::app {

namespace {

int check(const std::string& path) {
  const auto report = check_path(path);
  if (!report) return exit_with(report.error());
  for (const Problem& p : report->problems) std::cerr << to_text(p) << '\n';
  std::cout << report->summary() << '\n';
  return report->problems.empty() ? 0 : 2;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "check", "Find every problem of an exhibit, a shelf, a vessel or a drawing");
  command->footer("Example: onggi check config/exhibit.toml");
  command->add_option("path", *path,
                      "An exhibit's, scene's, drawing's or language's TOML, a vessel, or a shelf "
                      "[config/exhibit.toml]");
  command->callback([path, &exit_code] { exit_code = check(*path); });
}

}  // namespace onggi::app

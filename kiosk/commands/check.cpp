#include <iostream>
#include <memory>

#include "kiosk/commands/commands.h"
#include "kiosk/exhibit/check_exhibit.h"

namespace onggi::commands {

namespace {

Result<int> check(const std::string& path) {
  const auto report = exhibit::check_path(path);
  if (!report) return tl::unexpected(report.error());
  for (const Problem& p : report->problems) std::cerr << to_text(p) << '\n';
  std::cout << report->summary() << '\n';
  return report->problems.empty() ? 0 : 2;
}

}  // namespace

Command check_command() {
  const auto path = std::make_shared<std::string>();
  return {.name = "check",
          .help = "Find every problem of an exhibit, a shelf, a vessel or a drawing",
          .examples = "Example: onggi check config/exhibit.toml",
          .options = {{"path", path.get(),
                       "An exhibit's, scene's, drawing's or language's TOML, a vessel, or a shelf "
                       "[config/exhibit.toml]"}},
          .run = [path] { return check(*path); }};
}

}  // namespace onggi::commands

#include <iostream>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/program/commands/commands.h"

namespace onggi::commands {

namespace {

struct CheckArguments {
  std::string path, config;
};

Result<int> check(const CheckArguments& arguments) {
  const auto report = exhibit::check_path(arguments.path, arguments.config);
  if (!report) return tl::unexpected(report.error());
  for (const Problem& p : report->problems) std::cerr << to_text(p) << '\n';
  for (const auto& file : report->files)
    std::cout << "checked " << terminal::plain(file.string()) << '\n';
  std::cout << report->summary() << '\n';
  return report->problems.empty() ? 0 : 2;
}

}  // namespace

cli::Command check_command() {
  const auto a = std::make_shared<CheckArguments>();
  return {.name = "check",
          .help = "Find every problem of an exhibit, a shelf, a vessel or a drawing",
          .examples =
              "Example: onggi check config/exhibit.toml\n"
              "It lists every file that it checks, and counts them at the end.",
          .options = {{"path", &a->path,
                       "An exhibit's, scene's, drawing's or language's TOML, a vessel, or a shelf "
                       "[the exhibit]"},
                      {"--config", &a->config,
                       "The exhibit's TOML [the one in the current folder, else the program's]"}},
          .run = [a] { return check(*a); }};
}

}  // namespace onggi::commands

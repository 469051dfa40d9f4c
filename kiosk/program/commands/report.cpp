#include <unistd.h>

#include <iostream>
#include <memory>
#include <string>

#include "engine/base/plain_text.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/support_bundle.h"

namespace onggi::commands {

namespace {

struct ReportArguments {
  std::string config, state, health;
  files::Output to{files::Output::Kind::archive, "onggi-report.tar.gz"};
};

Result<int> report(const ReportArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  BundleSources sources;
  sources.config = *config;
  if (!arguments.state.empty()) sources.state = arguments.state;
  if (!arguments.health.empty()) sources.health = arguments.health;
  const bool watched = isatty(STDERR_FILENO) != 0;
  const auto parts = gather_bundle(sources, [watched](const std::string& what) {
    if (watched) std::cerr << "collecting " << what << " ...\n";
  });
  const auto packed = pack_bundle(parts);
  if (!packed) return tl::unexpected(packed.error());
  if (auto written = arguments.to.write(*packed); !written) return tl::unexpected(written.error());
  if (arguments.to.to_stdout()) return 0;
  std::cout << "Wrote " << terminal::plain(arguments.to.where()) << ", "
            << packed->size() / 1024 + 1 << " kB:\n";
  for (const BundlePart& part : parts) std::cout << "  " << part.name << '\n';
  std::cout << "It holds nothing about visitors. Check it before you send it: tar -xzf "
            << terminal::plain(arguments.to.where()) << '\n';
  return 0;
}

}  // namespace

cli::Command report_command() {
  const auto a = std::make_shared<ReportArguments>();
  return {
      .name = "report",
      .help = "Pack what a helper needs to find a fault, and nothing about visitors",
      .examples =
          "Example: sudo onggi report --config /srv/onggi/config/exhibit.toml -o "
          "/tmp/onggi.tar.gz\n"
          "With sudo it includes the log. It holds version, machine, configuration, onggi check, "
          "health, crashes, log, disk and counts.",
      .options = {{"-o,--to", &a->to, "The file to write [onggi-report.tar.gz]"},
                  {"--config", &a->config,
                   "The exhibit's TOML [the one in the current folder, else the program's]"},
                  {"--state", &a->state, "The service's state [/var/lib/onggi]"},
                  {"--health", &a->health, "The service's health [/run/onggi/onggi.prom]"}},
      .run = [a] { return report(*a); }};
}

}  // namespace onggi::commands

#include <csignal>
#include <memory>
#include <string>

#include "kiosk/app/commands/commands.h"
#include "kiosk/app/kiosk.h"
#include "kiosk/app/log.h"
#include "kiosk/app/monotonic.h"
#include "kiosk/app/paths.h"
#include "kiosk/app/window_size.h"

namespace onggi::app {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

struct RunArguments {
  std::string config, window, shelf;
};

int run(const RunArguments& arguments) {
  const auto config = exhibit_file(arguments.config);
  if (!config) return exit_with(config.error());
  KioskOptions options;
  options.config = *config;
  options.seed = static_cast<std::uint64_t>(monotonic_seconds() * 1e6);
  if (!arguments.shelf.empty()) options.shelf = arguments.shelf;
  if (auto good = read_window_size(arguments.window, options.window); !good)
    return exit_with(good.error());

  std::signal(SIGINT, [](int) { asked_to_stop = 1; });
  std::signal(SIGTERM, [](int) { asked_to_stop = 1; });
  auto kiosk = Kiosk::open(options);
  if (!kiosk) return exit_with(kiosk.error());
  bool first = true;
  while (asked_to_stop == 0 && (*kiosk)->frame(monotonic_seconds())) {
    if (first && (*kiosk)->open_to_visitors()) {
      first = false;
      log_line("First picture " + std::to_string(static_cast<int>(since_exec_seconds() * 1000)) +
               " ms after the start of the program.");
    }
  }
  return 0;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Open the exhibit full screen");
  command->footer("Example: onggi run --config config/exhibit.toml --window 1280x720");
  // The same options with and without the word "run": a kiosk is started by its bare name.
  for (CLI::App* at : {&app, command}) {
    at->add_option("--config", arguments->config, "The exhibit's TOML [config/exhibit.toml]");
    at->add_option("--window", arguments->window,
                   "A window of WIDTHxHEIGHT pixels instead of full screen");
    at->add_option("--shelf", arguments->shelf,
                   "A folder of vessels (packs, .glb, .gltf) instead of the exhibit's");
  }
  app.callback([&app, arguments, &exit_code] {
    if (app.get_subcommands().empty() || app.got_subcommand("run")) exit_code = run(*arguments);
  });
}

}  // namespace onggi::app

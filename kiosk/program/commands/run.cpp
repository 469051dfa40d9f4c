#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/composition/reload.h"
#include "kiosk/ground/files/files_read.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/picture/render/window_size.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/posted_state.h"
#include "kiosk/program/commands/service_run.h"

namespace onggi::commands {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

struct RunArguments {
  std::string config, window, shelf;
};

enum class Ending { asked_to, reload };

/// Runs the exhibit of `options` (the museum's, or one that `stands_in` for it) until somebody asks
/// it to end, or until the museum's has changed and no visitor is here.
Result<Ending> show_exhibit(const exhibit::KioskOptions& options, bool stands_in,
                            exhibit::Reload& reload, ServiceRun* service_run, PostedState& posted) {
  if (service_run != nullptr) service_run->opens(options.config, stands_in);
  auto kiosk = exhibit::Kiosk::open(options);
  if (!kiosk) return tl::unexpected(kiosk.error());
  if (service_run != nullptr) service_run->shows(**kiosk);
  posted.shows(**kiosk, options.config, stands_in);
  bool first = true;
  while (asked_to_stop == 0 && (*kiosk)->frame(files::monotonic_seconds())) {
    posted.look(**kiosk, files::monotonic_seconds());
    if (service_run != nullptr) service_run->look(**kiosk);
    if (!(*kiosk)->doing().open_to_visitors) continue;
    if (std::exchange(first, false))
      files::log_line("First picture " +
                      std::to_string(static_cast<int>(files::since_exec_seconds() * 1000)) +
                      " ms after the start of the program.");
    // Start watching only now, because the shelf was just read.
    if (!(*kiosk)->shelf().complete()) continue;
    reload.look(files::monotonic_seconds());
    if (reload.wanted() && (*kiosk)->doing().nobody_is_here) return Ending::reload;
  }
  return Ending::asked_to;
}

Result<int> open_exhibit(const exhibit::KioskOptions& museums, ServiceRun* service_run) {
  using exhibit::Reload;
  std::optional<exhibit::KioskOptions> safer;
  if (service_run != nullptr) safer = service_run->safer(museums);
  PostedState posted;
  Reload reload(museums.config, safer ? Reload::Shown::another : Reload::Shown::this_one);
  for (;;) {
    const auto ending =
        show_exhibit(safer ? *safer : museums, safer.has_value(), reload, service_run, posted);
    if (!ending) return tl::unexpected(ending.error());
    if (*ending == Ending::asked_to) break;
    reload.taken_up();
    safer.reset();
  }
  if (service_run != nullptr) service_run->end();
  return 0;
}

Result<int> run(const RunArguments& arguments) {
  const auto config = files::exhibit_file(arguments.config);
  if (!config) return tl::unexpected(config.error());
  exhibit::KioskOptions options;
  options.config = *config;
  options.seed = static_cast<std::uint64_t>(files::monotonic_seconds() * 1e6);
  if (!arguments.shelf.empty()) options.shelf = arguments.shelf;
  if (auto good = render::read_window_size(arguments.window, options.window); !good)
    return tl::unexpected(good.error());

  files::note_reads(false);  // it reads keepsakes for months, and writes no output over them
  std::signal(SIGINT, [](int) { asked_to_stop = 1; });
  std::signal(SIGTERM, [](int) { asked_to_stop = 1; });
  const std::optional<std::filesystem::path> state = ServiceRun::state_folder();
  if (!state) return open_exhibit(options, nullptr);
  ServiceRun service_run(*state);
  return open_exhibit(options, &service_run);
}

}  // namespace

cli::Command run_command() {
  const auto a = std::make_shared<RunArguments>();
  return {.name = "run",
          .help = "Open the exhibit full screen",
          .examples = "Example: onggi run --config config/exhibit.toml --window 1280x720",
          .options = {{"--config", &a->config, "The exhibit's TOML [config/exhibit.toml]"},
                      {"--window", &a->window,
                       "A window of WIDTHxHEIGHT pixels instead of full screen"},
                      {"--shelf", &a->shelf,
                       "A folder of vessels (packs, .glb, .gltf) instead of the exhibit's"}},
          .run = [a] { return run(*a); }};
}

}  // namespace onggi::commands

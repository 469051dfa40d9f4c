#include "kiosk/program/commands/service_run.h"

#include <cstdlib>
#include <string>
#include <utility>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/commands/posted_state.h"
#include "kiosk/program/watch/last_good.h"
#include "kiosk/program/watch/service.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

/// systemd gives a service its folders in these variables; several are separated by colons.
std::optional<fs::path> folder_given(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return {};
  const std::string folders = value;
  return fs::path(folders.substr(0, folders.find(':')));
}

settings::Problems problems_of(const fs::path& exhibit) {
  return settings::read_exhibit(exhibit, files::language_folder(exhibit)).problems;
}

}  // namespace

std::optional<fs::path> ServiceRun::state_folder() { return folder_given("STATE_DIRECTORY"); }

ServiceRun::ServiceRun(fs::path state) : state_(std::move(state)), history_(state_) {
  if (auto begun = history_.begin(); !begun) files::log_problem(begun.error());
}

std::optional<exhibit::KioskOptions> ServiceRun::safer(const exhibit::KioskOptions& museums) {
  exhibit::KioskOptions options = museums;
  const auto good = watch::last_good(state_);
  if (!history_.safe()) {
    const settings::Problems wrong = problems_of(museums.config);
    // If the last good one has problems too, the kiosk has shown that it can run with them.
    if (wrong.empty() || !good || !problems_of(good->exhibit).empty()) return {};
    files::log_problems(wrong);
    files::log_line("The last good exhibit is shown until you fix this.");
    options.config = good->exhibit;
    options.keepsakes = good->keepsakes;
    return options;
  }
  files::log_line("Safe mode: the last " + std::to_string(history_.crashes()) +
                  " runs crashed. Mouse and touch only. Read the log above, and run onggi "
                  "check.");
  options.devices = false;
  options.shelf.reset();
  if (good && history_.crashes() < 2 * watch::RunHistory::kMostCrashes) {
    options.config = good->exhibit;
    options.keepsakes = good->keepsakes;
  } else if (const auto root = files::program_root()) {
    options.config = *root / "config" / "exhibit.toml";
    options.keepsakes = watch::remembered_keepsakes(state_).value_or(state_ / "keepsakes");
  }
  files::log_line("The exhibit is " + options.config.string());
  return options;
}

void ServiceRun::opens(const fs::path& config, bool stands_in) {
  shown_ = {};
  shown_.safe = stands_in;
  const fs::path site = files::site_exhibit(config);
  if (stands_in || site != fs::absolute(config).lexically_normal()) return;
  shown_.site = site.parent_path().parent_path();
  if (auto files = watch::files_of(shown_.site))
    shown_.files = std::move(*files);
  else
    files::log_problem(files.error());
}

void ServiceRun::shows(const exhibit::Kiosk& kiosk) {
  if (!watchdog_) {
    watch::WatchdogOptions options;
    options.state = state_;
    if (const auto folder = folder_given("RUNTIME_DIRECTORY"))
      options.health = *folder / "onggi.prom";
    options.version = ONGGI_VERSION;
    options.watchdog_s = watch::Service::watchdog_s();
    watchdog_ = std::make_unique<watch::WatchdogThread>(options, history_);
  }
  shown_.keepsakes = kiosk.doing().keepsake_folder;
  watchdog_->shows(shown_);
  before_ = watch::together(before_, std::exchange(health_, {}));
}

void ServiceRun::look(exhibit::Kiosk& kiosk) {
  count_frame(kiosk, health_);
  const watch::Health all = watch::together(before_, health_);
  watchdog_->look({all.frames, all.wakes, kiosk.doing().device_moves.value_or(all.frames)}, all,
                  files::monotonic_seconds());
  for (const std::string& line : watchdog_->remarks()) files::log_line(line);
}

void ServiceRun::end() {
  watch::Service::ends();
  watchdog_.reset();
  if (auto ended = history_.ended(); !ended) files::log_problem(ended.error());
}

}  // namespace onggi::commands

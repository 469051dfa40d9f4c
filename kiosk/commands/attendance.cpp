#include "kiosk/commands/attendance.h"

#include <cstdlib>
#include <string>

#include "kiosk/exhibit/log.h"
#include "kiosk/exhibit/paths.h"
#include "kiosk/measure/monotonic.h"
#include "kiosk/watch/last_good.h"
#include "kiosk/watch/service.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

/// systemd gives a service folders of its own by these names; several are apart by colons.
std::optional<fs::path> folder_given(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return {};
  const std::string folders = value;
  return fs::path(folders.substr(0, folders.find(':')));
}

}  // namespace

std::optional<fs::path> Attendance::state_folder() { return folder_given("STATE_DIRECTORY"); }

Attendance::Attendance(fs::path state) : state_(std::move(state)), ledger_(state_) {
  if (auto begun = ledger_.begin(); !begun) exhibit::log_problem(begun.error());
}

void Attendance::choose(exhibit::KioskOptions& options) {
  if (!ledger_.safe()) return;
  exhibit::log_line("Safe mode: the last " + std::to_string(ledger_.crashes()) +
                    " runs crashed. Mouse and touch only. Look at the log above, and run onggi "
                    "check.");
  options.devices = false;
  options.shelf.reset();
  if (const auto good = watch::last_good(state_)) {
    options.config = good->exhibit;
    options.keepsakes = good->keepsakes;
  } else if (const auto root = exhibit::program_root()) {
    options.config = *root / "config" / "exhibit.toml";
    options.keepsakes = state_ / "keepsakes";
  }
  exhibit::log_line("The exhibit is " + options.config.string());
}

void Attendance::begin(const exhibit::Kiosk& kiosk, const fs::path& config) {
  watch::KeeperOptions options;
  options.state = state_;
  if (const auto folder = folder_given("RUNTIME_DIRECTORY"))
    options.health = *folder / "onggi.prom";
  // What is shown in safe mode has been kept already.
  if (const fs::path site = exhibit::site_exhibit(config);
      !ledger_.safe() && site == fs::absolute(config))
    options.site = site.parent_path().parent_path();
  options.keepsakes = kiosk.keepsake_folder();
  options.version = ONGGI_VERSION;
  options.watchdog_s = watch::Service::watchdog_s();
  keeper_ = std::make_unique<watch::Keeper>(options, ledger_);
}

void Attendance::look(exhibit::Kiosk& kiosk) {
  const loop::LoopStatus status = kiosk.potter().status();
  watch::Health health;
  health.frames = ++frames_;
  health.wakes = status.deadlines.wakes;
  health.late = status.deadlines.late;
  health.overruns = status.deadlines.overruns;
  health.lost_ticks = status.deadlines.lost_ticks;
  health.worst_wake_s = 1e-6 * status.deadlines.worst_wake_us;
  health.kept = kiosk.saved().kept;
  health.not_kept = kiosk.saved().refused;
  keeper_->look({health.frames, health.wakes}, health, measure::monotonic_seconds());
  for (const std::string& line : keeper_->remarks()) exhibit::log_line(line);
}

void Attendance::end() {
  watch::Service::ends();
  keeper_.reset();
  if (auto ended = ledger_.ended(); !ended) exhibit::log_problem(ended.error());
}

}  // namespace onggi::commands

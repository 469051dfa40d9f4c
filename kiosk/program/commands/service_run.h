#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/program/watch/run_history.h"
#include "kiosk/program/watch/watchdog_thread.h"

namespace onggi::commands {

/// Runs the kiosk as a systemd service: feeds the watchdog, counts crashes, and replaces an exhibit
/// that crashes or is broken with the last good one.
class ServiceRun {
 public:
  /// The service's state folder (systemd's StateDirectory); empty if not started by systemd.
  static std::optional<std::filesystem::path> state_folder();

  explicit ServiceRun(std::filesystem::path state);

  /// The exhibit to show instead of the museum's, if any: the last good one after too many crashes,
  /// or if the museum's was broken while the machine was off. After crashes there are only mouse
  /// and touch. The program's own exhibit is shown if no good one is saved, or if that one crashed
  /// as often. Writes this to the log.
  std::optional<exhibit::KioskOptions> safer(const exhibit::KioskOptions& museums);
  /// Call before `config` is opened: its current files may become the last good exhibit, unless it
  /// only `stands_in` for the museum's.
  void opens(const std::filesystem::path& config, bool stands_in);
  /// The kiosk is open. Call again after each reload.
  void shows(const exhibit::Kiosk& kiosk);
  /// Call once a frame.
  void look(exhibit::Kiosk& kiosk);
  /// The kiosk ends on request.
  void end();

 private:
  std::filesystem::path state_;
  watch::RunHistory history_;
  std::unique_ptr<watch::WatchdogThread> watchdog_;
  watch::Shown shown_;    ///< As opens() found it.
  watch::Health health_;  ///< Health of the open kiosk,
  watch::Health before_;  ///< and the counts of the kiosks before it in this run.
};

}  // namespace onggi::commands

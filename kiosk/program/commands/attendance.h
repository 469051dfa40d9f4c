#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/program/watch/keeper.h"
#include "kiosk/program/watch/run_ledger.h"

namespace onggi::commands {

/// A run of the kiosk as a service, which nobody attends: systemd's watchdog is fed, crashes are
/// counted, and an exhibit that crashes or is broken gives way to the last one that was good.
class Attendance {
 public:
  /// Where a service keeps its state (systemd's StateDirectory); none where this is no service.
  static std::optional<std::filesystem::path> state_folder();

  explicit Attendance(std::filesystem::path state);

  /// What to show instead of the museum's exhibit, if anything: after too many crashes, or where
  /// it was broken while the machine was off, the last one that was good. After crashes, mouse and
  /// touch only, the program's own exhibit where none is kept, and that too where the last good one
  /// crashed as often. Says so in the log.
  std::optional<exhibit::KioskOptions> safer(const exhibit::KioskOptions& museums);
  /// Before `config` is opened: what lies there now is what may become the last good one, unless it
  /// only `stands_in` for the museum's.
  void opens(const std::filesystem::path& config, bool stands_in);
  /// The kiosk is open. Again after each reload.
  void shows(const exhibit::Kiosk& kiosk);
  /// Once a frame.
  void look(exhibit::Kiosk& kiosk);
  /// It ends because it was asked to.
  void end();

 private:
  std::filesystem::path state_;
  watch::RunLedger ledger_;
  std::unique_ptr<watch::Keeper> keeper_;
  watch::Shown shown_;    ///< As opens() found it.
  watch::Health health_;  ///< Of the kiosk that is open,
  watch::Health before_;  ///< and the counts of those before it in this run.
};

}  // namespace onggi::commands

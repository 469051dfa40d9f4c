#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "kiosk/exhibit/kiosk.h"
#include "kiosk/watch/keeper.h"
#include "kiosk/watch/run_ledger.h"

namespace onggi::commands {

/// A run of the kiosk as a service, which nobody attends: systemd's watchdog is fed, crashes are
/// counted, and after four of them at the start the last exhibit that was good is shown.
class Attendance {
 public:
  /// Where a service keeps its state (systemd's StateDirectory); none where this is no service.
  static std::optional<std::filesystem::path> state_folder();

  explicit Attendance(std::filesystem::path state);

  /// After too many crashes the last good exhibit takes the place of the one in `options`, or the
  /// program's own where none is kept, and only mouse and touch are used. Says so in the log.
  void choose(exhibit::KioskOptions& options);
  /// The kiosk is open; `config` is the exhibit that it shows.
  void begin(const exhibit::Kiosk& kiosk, const std::filesystem::path& config);
  /// Once a frame.
  void look(exhibit::Kiosk& kiosk);
  /// It ends because it was asked to.
  void end();

 private:
  std::filesystem::path state_;
  watch::RunLedger ledger_;
  std::unique_ptr<watch::Keeper> keeper_;
  std::uint64_t frames_ = 0;
};

}  // namespace onggi::commands

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/program/setup/addresses.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// The museum's own exhibit on a machine that was set up.
inline constexpr const char* kSite = "/srv/onggi";
/// The changes that setup made, for undoing them: a line a step, fields separated by tabs. It is in
/// root's own folder, because the kiosk's user must not control what root undoes.
inline constexpr const char* kChanges = "/var/lib/onggi-setup/changed";

/// Where the service of the staff's page keeps who may use it.
inline constexpr const char* kConsoleState = "/var/lib/onggi-console";

struct SetupOptions {
  System system{};
  std::filesystem::path data = "/usr/share/onggi";  ///< On the system: config/, content/, system/.
  bool dry = false;                                 ///< Report the changes without making them.
  /// Where staff reach their page, which then starts with the machine (staff_address()); kChoose:
  /// the only address. Empty: no page.
  std::string console{};
  std::vector<MachineAddress> addresses{};  ///< Of the machine.
  bool replace_desktop = false;  ///< Stop a display manager from starting with the machine.
};

/// The results of a setup, in order.
struct SetupReport {
  std::vector<std::string> changed;  ///< One line for each change,
  std::vector<std::string> stayed;   ///< and one for each thing that was already right or was kept.
};

/// The steps from a bare Debian with the package to a kiosk: the museum's own exhibit, the screen,
/// the log's limit, the file for node_exporter, the units. Problem (exit 1) if a desktop holds the
/// screen and may not be replaced.
Result<std::vector<Step>> kiosk_steps(const SetupOptions& options);

/// Runs all of kiosk_steps() in order, and records each change in kChanges before the next step.
/// Stops at a failed step; a second setup continues from there. It does not give the museum
/// anything twice: a vessel that was taken off the shelf stays off. Problem (exit 1) without
/// root's rights, and those of apply(). Blocks; any thread.
Result<SetupReport> set_up(const SetupOptions& options);

/// Gives the users of the programs what they need of the folders that an earlier setup made, when
/// no such users were, and takes nothing away. The package calls it after an upgrade.
Result<SetupReport> renew_rights(const SetupOptions& options);

/// Undoes the changes that set_up() recorded, last first, and clears the record; `dry` only
/// reports. Problem (exit 2) if nothing is recorded.
Result<SetupReport> undo_setup(const System& system, bool dry = false);

}  // namespace onggi::setup

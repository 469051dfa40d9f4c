#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// Where the museum's own exhibit lies on a machine that was set up.
inline constexpr const char* kSite = "/srv/onggi";
/// What setup changed on it, for taking it back: a line a step, its fields apart by tabs.
/// Root's own folder: who runs the kiosk must not say what root takes back.
inline constexpr const char* kChanges = "/var/lib/onggi-setup/changed";

struct SetupOptions {
  System system{};
  std::filesystem::path data = "/usr/share/onggi";  ///< On the system: config/, content/, system/.
  bool dry = false;                                 ///< Say what would change, and change nothing.
  bool replace_desktop = false;  ///< A display manager no longer starts with the machine.
};

/// What setup found and did, in order.
struct SetupReport {
  std::vector<std::string> changed;  ///< One line a change,
  std::vector<std::string> stayed;   ///< and one for what was so already or was left.
};

/// The steps from a bare Debian with the package to a kiosk: the museum's own exhibit, the
/// screen, the log's bound, the place in node_exporter, the units. Problem (exit 1) where a desktop
/// would hold the screen and may not be replaced.
Result<std::vector<Step>> kiosk_steps(const SetupOptions& options);

/// Takes all of kiosk_steps(), in order, and remembers what changed in kChanges before the next. A
/// step that fails ends it; a second setup goes on from there. What it gave the museum once, or
/// found there, it does not give again: a vessel that was taken off the shelf stays off. Problem
/// (exit 1) without root's rights, and those of apply(). Blocks; any thread.
Result<SetupReport> set_up(const SetupOptions& options);

/// Takes back what set_up() remembers, last first, and forgets it; `dry` only tells.
/// Problem (exit 2) where nothing is remembered.
Result<SetupReport> undo_setup(const System& system, bool dry = false);

}  // namespace onggi::setup

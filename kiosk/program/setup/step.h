#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::setup {

/// The system to set up: this one, or an image of one in a folder.
struct System {
  std::filesystem::path root = "/";
  /// The path on this machine of `path` on that system.
  std::filesystem::path at(const std::filesystem::path& path) const {
    return root / path.relative_path();
  }
  /// True for this running machine with systemd: its services can be started and stopped.
  bool runs() const;
};

/// One change that setup makes.
struct Step {
  enum class Kind {
    folder,  ///< `to` exists and belongs to the user onggi.
    tree,    ///< Copies the file, or every file of the folder, `from` to `to`; existing files stay.
    link,    ///< Makes `to` a symbolic link to `from`; anything else there stays.
    unlink,  ///< Removes the symbolic link `to` to `from`.
    enable,  ///< Starts the unit `to` with the machine.
    disable,      ///< Stops starting the unit `to` with the machine.
    share,        ///< The group `from` may write in the folder `to` (rights.h).
    file,         ///< Writes `text` to `to`; a file there that setup did not write stays.
    mask,         ///< The unit file `to` can never start.
    package,      ///< The program `to` is there; else the Debian package `from` is installed.
    certificate,  ///< Makes the certificate `to` with the key `from` for the names in `text`.
  };
  Kind kind = Kind::folder;
  std::filesystem::path to;      ///< A path of the system; a unit's name.
  std::filesystem::path from{};  ///< For tree, link and unlink: a path of the system.
  std::string why{};             ///< "the exhibit, yours to change"
  bool needs_folder = false;     ///< For link: skipped if the folder of `to` is missing.
  std::string text{};  ///< For file: its content. For certificate: "IP:1.2.3.4,DNS:kiosk".
};

/// The first line of each file that setup writes. Without it, the file is the museum's own.
inline constexpr const char* kMadeLine = "# Made by onggi setup";

/// The result of a step.
struct Change {
  bool changed = false;  ///< False: it was already so, or it was kept for a reason in `told`.
  std::string told;      ///< One line for the person who runs setup.
};

/// Makes the change, or reports it if `dry`. Problem (exit 1) if the disk, the permissions or
/// systemctl refuse. Blocks; any thread.
Result<Change> apply(const Step& step, const System& system, bool dry);

/// Undoes a change of apply(), if the system is still as apply() left it. Later changes stay, and
/// so do the museum's files (folder and tree) and changes that cannot be undone (a removed unit).
/// On a running system, units are stopped or started at once. `dry` only reports.
Result<Change> take_back(const Step& step, const System& system, bool dry);

}  // namespace onggi::setup

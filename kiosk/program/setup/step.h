#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::setup {

/// The system that becomes a kiosk: this one, or an image of one under a folder.
struct System {
  std::filesystem::path root = "/";
  /// Where `path` of that system lies on this one.
  std::filesystem::path at(const std::filesystem::path& path) const {
    return root / path.relative_path();
  }
  /// It is the one that runs here, with systemd: its services can be started and ended.
  bool runs() const;
};

/// One thing that setup brings about.
struct Step {
  enum class Kind {
    folder,   ///< `to` exists and belongs to the user onggi.
    tree,     ///< The file, or every file of the folder, `from` is at `to`; what is there stays.
    link,     ///< `to` is a symbolic link to `from`; where something else is, that stays.
    unlink,   ///< The symbolic link `to` to `from` is gone.
    enable,   ///< The unit `to` starts with the machine.
    disable,  ///< The unit `to` does not.
  };
  Kind kind = Kind::folder;
  std::filesystem::path to;      ///< A path of the system; a unit's name.
  std::filesystem::path from{};  ///< Of tree, link and unlink: a path of the system.
  std::string why{};             ///< "the exhibit, yours to change"
  bool needs_folder = false;     ///< Of link: left out where the folder of `to` is not there.
};

/// What a step came to.
struct Change {
  bool changed = false;  ///< False: it was so already, or stayed for a reason that `told` names.
  std::string told;      ///< One line for whoever set the machine up.
};

/// Brings `step` about, or says what it would do when `dry`. Problem (exit 1) where the disk, the
/// rights or systemctl refuse. Blocks; any thread.
Result<Change> apply(const Step& step, const System& system, bool dry);

/// Takes back what apply() changed, where it is still as apply() left it; what has been changed
/// since stays, and so does what belongs to the museum (folder and tree) and what cannot be taken
/// back any more (a unit that is gone). On a system that runs, a unit is ended, or started, at
/// once. `dry` only tells.
Result<Change> take_back(const Step& step, const System& system, bool dry);

}  // namespace onggi::setup

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/changes/draft.h"
#include "kiosk/collection/changes/revisions.h"

namespace onggi::editing {

/// What set_values() did.
struct Edited {
  changes::Revision revision;     ///< With no values if the file had them all already.
  bool restarts_console = false;  ///< onggi-console must be started again.
};

/// Set where the file is not the one that a change was meant for.
inline constexpr int kAnotherFile = 3;

/// What `file` would hold with `changes`; nothing is written. Problem, exit 2, for a key or value
/// that cannot be, and for a file with a fault of TOML.
Result<changes::Draft> with_changes(const std::filesystem::path& file,
                                    const std::vector<changes::Change>& changes);

/// Makes `changes` in `file`, in one step: all of them or none. Every other byte of the file stays.
/// What `onggi check` would find wrong is refused, and nothing is written. The change is kept as a
/// revision. Kill the process at any point, and the file is the old one or the new one, whole.
/// `tag`: of the file that the changes are meant for (changes::tag_of()), so that nobody's work is
/// overwritten unseen; "": any. Problem: exit 2 for a wrong key or value, kAnotherFile for another
/// tag, 1 for what the disk does not allow.
Result<Edited> set_values(const std::filesystem::path& file,
                          const std::vector<changes::Change>& changes, const std::string& tag = "");

/// What undo() did.
struct Undone {
  changes::Revision revision;
  bool kept_others = false;  ///< The file had changed since, and that stays.
};

/// Takes back the newest revision of the exhibit that `file` belongs to, whichever file it changed,
/// and forgets it. Where that file was changed by hand since, the hand's changes stay: only the
/// value is put back, if it still stands as it was set. Problem where it does not, where there is
/// nothing to take back, and where `onggi check` would find a new fault. `id`: of the revision that
/// is meant (its file's name, without .toml); kAnotherFile if it is not the newest any more; "":
/// any.
Result<Undone> undo(const std::filesystem::path& file, const std::string& id = "");

/// Forgets the newest revision, and leaves its file as it is. `id`: as for undo().
Result<changes::Revision> forget_newest(const std::filesystem::path& file,
                                        const std::string& id = "");

}  // namespace onggi::editing

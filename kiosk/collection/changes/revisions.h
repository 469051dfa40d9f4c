#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/changes/draft.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::changes {

/// One change of one file, as it is kept: enough to take it back, and to tell it in words.
struct Revision {
  std::filesystem::path file;
  std::string when;  ///< "2026-11-29 12:01", local time.
  std::vector<ChangedValue> values;
  std::size_t at = 0;                   ///< The first byte that changed,
  std::string was, is;                  ///< the bytes that stood there, and that stand there now,
  std::uint32_t before = 0, after = 0;  ///< and CRC-32 of the whole file.
  std::filesystem::path kept_in;        ///< Its own file; set by read_revisions().

  /// Takes the change from `now` to what was there before, or back: nothing if `now` is not the
  /// file as the change left it.
  std::optional<std::string> taken_from(const std::string& now) const;
  /// True if `now` is the file as it was before the change.
  bool not_carried_out(const std::string& now) const;
};

/// What turned `before` into `after`, without names.
Revision revision_of(const std::string& before, const std::string& after);

/// "idle.warn_after: 60 -> 90", a line each. Long values are cut.
std::string words_of(const Revision& revision);

/// What a change did: "idle.warn_after is 90 now. It was 60."
std::string change_words(const ChangedValue& value);
/// What taking it back did: "idle.warn_after is 60 again. It was 90 since 2026-11-29 12:01."
std::string undo_words(const ChangedValue& value, const std::string& when);

/// The revisions of one exhibit, in a folder `revisions` beside `config` and `content`: there they
/// outlive a moved folder of keepsakes, and are in neither of the folders that museums copy. Its
/// own .gitignore keeps it out of a versioned exhibit. Outside of an exhibit the folder is beside
/// the file. Each function blocks on the disk; the lock is for one process at a time.
class Revisions {
 public:
  static constexpr std::size_t kKept = 20;

  /// For the exhibit that `file` belongs to. Touches nothing.
  explicit Revisions(const std::filesystem::path& file);

  const std::filesystem::path& folder() const { return folder_; }
  /// Makes the folder, waits for other processes, and removes what a killed one left. Held until
  /// this object ends. Problem (exit 1).
  Result<void> lock();
  /// Newest first. One that a killed process did not carry out is not among them; a damaged one is
  /// left out.
  std::vector<Revision> read() const;
  /// What the next one will be called (its file's name, without .toml), if no other process keeps
  /// one first.
  std::string next_id() const;
  /// Keeps `revision` as the newest, before its file is replaced. Problem (exit 1).
  Result<void> keep(Revision& revision) const;
  /// Forgets one. Problem (exit 1).
  Result<void> forget(const Revision& revision) const;
  /// Forgets all but the newest kKept, and those that were not carried out.
  void tidy() const;

 private:
  std::vector<std::filesystem::path> kept() const;
  std::optional<Revision> read_one(const std::filesystem::path& file) const;

  std::filesystem::path site_, folder_;
  files::Descriptor lock_;
};

}  // namespace onggi::changes

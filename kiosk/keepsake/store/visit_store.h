#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/souvenir/fetch_note.h"
#include "kiosk/keepsake/store/database.h"
#include "kiosk/keepsake/store/visit_record.h"

namespace onggi::store {

/// The kiosk's file of visits. One thread; each call may wait for the disk, so frames do not call
/// it (StoreThread).
class VisitStore {
 public:
  /// Opens `file`, creating it and its folder if missing, and migrates it from any former version.
  /// A damaged file, or one that is not a store, is set aside (set_aside) and reported in
  /// `remarks`, and a new one with a new epoch is started. Problem, exit 1: the disk refuses,
  /// another onggi uses it, or a newer onggi made it; the file is unchanged.
  static Result<VisitStore> open(const std::filesystem::path& file, const std::string& stamp,
                                 std::vector<Problem>& remarks);

  /// Renames `file`, which must be closed, to FILE.damaged-`stamp`, with its log. Returns the
  /// message for staff, or the Problem, exit 1, that it cannot be renamed.
  static Result<Problem> set_aside(const std::filesystem::path& file, const std::string& stamp);
  /// Removes files set aside with a stamp (files::kStamp) before the local `day`, and no others.
  /// Problem, exit 1: one of them cannot be removed.
  static Result<void> forget_aside(const std::filesystem::path& file, const std::string& day);

  /// True if somebody removed or replaced the file, so that writing to it is lost.
  bool taken_away() const;
  /// files::clock_jumped for the visits' start times, at `now`, s since 1970.
  Result<bool> clock_jumped(std::int64_t now);
  /// Adds all of `visits` in one transaction: all or none.
  Result<void> add(std::span<const VisitRecord> visits);
  /// Adds keepsakes that were opened on a phone, each only once; all of `notes` or none.
  Result<void> add_fetches(std::span<const souvenir::FetchNote> notes);
  /// Deletes visits and fetches before the local `day`, also from the file's free space and its
  /// log.
  Result<void> forget_before(const std::string& day);

  /// Why the last call failed; damage stays.
  Trouble trouble() const { return database_.trouble(); }

 private:
  VisitStore(std::filesystem::path file, Database database);
  tl::unexpected<Problem> failed(const std::string& what) const;

  std::filesystem::path file_;
  Database database_;
  std::uint64_t inode_ = 0;  ///< Inode of `file_`, unless somebody removed it.
};

/// The Problem of a newer onggi's file with `version`, and the remedy.
Problem newer_store(const std::filesystem::path& file, std::int64_t version,
                    const std::string& remedy, int exit_code);

}  // namespace onggi::store

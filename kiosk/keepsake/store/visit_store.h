#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/fetch_note.h"
#include "kiosk/keepsake/store/database.h"
#include "kiosk/keepsake/store/visit_record.h"

namespace onggi::store {

/// The kiosk's own file of visits. Any one thread; each call may wait for the disk, so no frame
/// makes it (StoreThread).
class VisitStore {
 public:
  /// Opens `file`, making it and its folder where they are missing, and brings it forward from any
  /// former version. A file that is damaged, or is no store, is set aside (set_aside), said in
  /// `remarks`, and a new one begun, with a new epoch. Problem, exit 1: the disk does not allow it,
  /// another onggi has it, or a newer onggi made it; the file is left as it is.
  static Result<VisitStore> open(const std::filesystem::path& file, const std::string& stamp,
                                 std::vector<Problem>& remarks);

  /// Renames `file`, which nobody has open, to FILE.damaged-`stamp`, with its log. What staff
  /// should know of it, or the Problem, exit 1, that it cannot be renamed.
  static Result<Problem> set_aside(const std::filesystem::path& file, const std::string& stamp);
  /// Removes what was set aside with a stamp (files::kStamp) before the local `day`; no other file.
  /// Problem, exit 1: one of them cannot be removed.
  static Result<void> forget_aside(const std::filesystem::path& file, const std::string& day);

  /// Somebody removed or replaced the file: what is written now goes nowhere.
  bool taken_away() const;
  /// files::clock_leapt of the visits' beginnings, at `now`, s since 1970.
  Result<bool> clock_leapt(std::int64_t now);
  /// All of `visits` in one transaction: all or none is kept.
  Result<void> add(std::span<const VisitRecord> visits);
  /// Keepsakes that were opened on a phone, each once however often it is handed over; all of
  /// `notes` or none.
  Result<void> add_fetches(std::span<const files::FetchNote> notes);
  /// Visits that began before the local `day`, and fetches before it, are forgotten: nothing of
  /// them is left in the file or its log.
  Result<void> forget_before(const std::string& day);

  /// What the last call failed by; damage stays.
  Trouble trouble() const { return database_.trouble(); }

 private:
  VisitStore(std::filesystem::path file, Database database);
  tl::unexpected<Problem> failed(const std::string& what) const;

  std::filesystem::path file_;
  Database database_;
  std::uint64_t inode_ = 0;  ///< What is at `file_` if nobody took it away.
};

/// A newer onggi's file: `version`, and what to do.
Problem newer_store(const std::filesystem::path& file, std::int64_t version,
                    const std::string& remedy, int exit_code);

}  // namespace onggi::store

#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/store/database.h"
#include "kiosk/store/visit_record.h"

namespace onggi::store {

/// The kiosk's own file of visits, keepsakes, settings and what a hub is to be told. Any one
/// thread; each call may wait for the disk, so no frame makes it (StoreThread).
class VisitStore {
 public:
  /// Opens `file`, making it and its folder where they are missing, and brings it forward from any
  /// former version. A damaged file is set aside as FILE.damaged-`stamp` (with its log), said in
  /// `remarks`, and a new one begun, with a new epoch. Problem, exit 1: the disk does not allow it,
  /// another onggi has it, or a newer onggi made it; the file is left as it is.
  static Result<VisitStore> open(const std::filesystem::path& file, const std::string& stamp,
                                 std::vector<Problem>& remarks);

  /// All of `visits` and their rows of the outbox in one transaction: all or none is kept.
  Result<void> add(std::span<const VisitRecord> visits);
  /// Visits that began before the local `day` are forgotten; what the hub is to be told stays.
  Result<void> forget_before(const std::string& day);

  Result<void> keep(const KeepsakeRecord& keepsake);
  /// The folder is gone.
  Result<void> dropped(const std::string& name);
  /// Keepsakes that are to go at `now` (s since 1970): those that have expired, and of the rest the
  /// oldest, until no more than `quota` bytes are kept. Oldest first.
  Result<std::vector<KeepsakeRecord>> due(std::int64_t now, std::int64_t quota);

  /// A setting of this machine; "" where it has none.
  Result<std::string> setting(const std::string& key);
  Result<void> set(const std::string& key, const std::string& value);

  /// 128 random bits in hexadecimal, born with the file: a hub tells by it that a sequence begins
  /// anew.
  Result<std::string> epoch();
  /// The oldest `most` rows that no hub has acknowledged.
  Result<std::vector<OutboxRow>> outbox(int most);
  /// A hub has all rows up to `seq`.
  Result<void> acknowledged(std::int64_t seq);

  /// What the last failure was.
  Trouble trouble() const { return database_.trouble(); }

 private:
  VisitStore(std::filesystem::path file, Database database)
      : file_(std::move(file)), database_(std::move(database)) {}
  tl::unexpected<Problem> failed(const std::string& what) const;
  Result<void> finish(Statement& statement, const std::string& what);

  std::filesystem::path file_;
  Database database_;
};

}  // namespace onggi::store

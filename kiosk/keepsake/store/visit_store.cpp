#include "kiosk/keepsake/store/visit_store.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <vector>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/keepsake/store/migrations.h"

namespace fs = std::filesystem;

namespace onggi::store {

namespace {

constexpr std::int64_t kQuarter = 15 * 60;  // s
constexpr const char* kAside = ".damaged-";

Problem problem_of(const fs::path& file, const std::string& what, const Database& database) {
  const std::string& words = database.message();
  switch (database.trouble()) {
    case Trouble::in_use:
      return {file.string(), what + ": another onggi has it open.",
              "Stop the other one. Play goes on, but visits are not counted here.", 1};
    case Trouble::unwritable:
      return {file.string(), what + ": " + words + ".",
              "Make room on the disk and the folder writable. Play goes on.", 1};
    case Trouble::damaged:
      return {file.string(), what + ": it is damaged (" + words + ").",
              "It is set aside. Play goes on.", 1};
    case Trouble::none:
    case Trouble::unfit:
    case Trouble::other:
      break;
  }
  return {file.string(), what + ": " + words + ".", "Play goes on. Please report it.", 1};
}

/// What visitors did is for the kiosk's user and group alone, so not for the program that phones
/// reach. SQLite gives its log the same rights.
void shut_to_others(const std::filesystem::path& file) {
  constexpr mode_t kMode = 0640;
  const files::Descriptor made(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kMode));
  for (const char* tail : {"", "-wal"}) {
    const std::string one = file.string() + tail;
    struct stat info {};
    if (::lstat(one.c_str(), &info) == 0 && S_ISREG(info.st_mode) && (info.st_mode & 07) != 0)
      static_cast<void>(::chmod(one.c_str(), info.st_mode & 0770));
  }
}

/// True if the file cannot be read to its end, or lacks tables of its version.
bool is_damaged(Database& database) {
  if (database.trouble() == Trouble::damaged) return true;
  if (database.trouble() != Trouble::none) return false;
  Statement check(database, "PRAGMA quick_check(1)");
  if (check.step()) return check.text(0) != "ok";
  return database.trouble() == Trouble::damaged;
}

/// Every table of the newest version is there.
bool is_whole(Database& database) {
  return database
      .number(
          "SELECT (SELECT count(value) FROM about) + (SELECT count(mission) FROM visits WHERE 0) + "
          "(SELECT count(day) FROM fetches WHERE 0)")
      .has_value();
}

/// True if the file's content shows that it is not a store; false if the disk refused to read it.
bool is_no_store(Trouble trouble) {
  return trouble == Trouble::none || trouble == Trouble::damaged || trouble == Trouble::unfit;
}

}  // namespace

Problem newer_store(const fs::path& file, std::int64_t version, const std::string& remedy,
                    int exit_code) {
  return {file.string(),
          "A newer onggi made it (version " + std::to_string(version) +
              ", but this one reads up to " + std::to_string(newest_version()) + ").",
          remedy, exit_code};
}

Result<Problem> VisitStore::set_aside(const fs::path& file, const std::string& stamp) {
  const std::string to = file.string() + kAside + stamp;
  std::error_code error;
  fs::rename(file, to, error);
  if (error)
    return problem(file.string(), "It is damaged and cannot be set aside: " + error.message() + ".",
                   "Make the folder writable. Play goes on; visits are not counted.", 1);
  for (const char* tail : {"-wal", "-shm"}) {
    std::error_code ignored;
    fs::rename(file.string() + tail, to + tail, ignored);
  }
  return Problem{file.string(),
                 "It was damaged and is set aside as " + fs::path(to).filename().string() +
                     "; counting starts again.",
                 "Nothing needs doing. To rescue its data, run: sqlite3 FILE .recover.", 1};
}

Result<void> VisitStore::forget_aside(const fs::path& file, const std::string& day) {
  const std::string prefix = file.filename().string() + kAside;
  Result<void> good;
  std::error_code error;
  fs::directory_iterator entry(file.parent_path(), error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const std::string stamp = name.substr(prefix.size());
    std::error_code failed;
    if (!files::begins_like(stamp, "9999-99-99_") || stamp >= day ||
        !entry->is_regular_file(failed))
      continue;
    fs::remove(entry->path(), failed);
    if (failed && good)
      good = problem(entry->path().string(),
                     "The store that was set aside could not be deleted: " + failed.message() + ".",
                     "Make the folder writable, or remove it.", 1);
  }
  return good;
}

Result<VisitStore> VisitStore::open(const fs::path& file, const std::string& stamp,
                                    std::vector<Problem>& remarks) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  for (const bool again : {false, true}) {
    shut_to_others(file);
    std::optional<Database> database(Database::open(file, Database::Mode::own));
    if (!is_damaged(*database) && database->trouble() == Trouble::none) {
      if (const auto version = database->number("PRAGMA user_version").value_or(0);
          version > newest_version())
        return tl::unexpected(newer_store(
            file, version, "Install the newer onggi again, or name another keepsake folder.", 1));
      if (migrate(*database) && is_whole(*database)) return VisitStore(file, std::move(*database));
    }
    if (again || !is_no_store(database->trouble()))
      return tl::unexpected(problem_of(file, "Visits cannot be counted", *database));
    database.reset();
    auto remark = set_aside(file, stamp);
    if (!remark) return tl::unexpected(remark.error());
    remarks.push_back(*remark);
  }
  return problem(file.string(), "Visits cannot be counted.", "Please report it.", 1);
}

VisitStore::VisitStore(fs::path file, Database database)
    : file_(std::move(file)), database_(std::move(database)) {
  struct stat now {};
  if (::stat(file_.c_str(), &now) == 0) inode_ = now.st_ino;
}

tl::unexpected<Problem> VisitStore::failed(const std::string& what) const {
  return tl::unexpected(problem_of(file_, what, database_));
}

bool VisitStore::taken_away() const {
  struct stat now {};
  return ::stat(file_.c_str(), &now) != 0 ? errno == ENOENT : now.st_ino != inode_;
}

Result<void> VisitStore::add(std::span<const VisitRecord> visits) {
  database_.retry();
  const auto written = [&] {
    if (!database_.run("BEGIN IMMEDIATE")) return false;
    Statement visit(database_,
                    "INSERT INTO visits (start, day, hour, vessel, scene, language, way, reached, "
                    "left_at, ended, active_s, throwing_s, pots, likeness, kept, mission) "
                    "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    for (const VisitRecord& v : visits) {
      const std::int64_t start = v.start - ((v.start % kQuarter) + kQuarter) % kQuarter;
      visit.bind(start).bind(v.day).bind(std::int64_t{v.hour}).bind(v.vessel).bind(v.scene);
      visit.bind(v.language).bind(v.way).bind(v.reached).bind(v.left).bind(v.ended);
      visit.bind(v.active_s).bind(v.throwing_s).bind(std::int64_t{v.pots}).bind(v.likeness);
      visit.bind(std::int64_t{v.kept}).bind(v.mission);
      visit.step();
      if (!visit.done()) return false;
      visit.reset();
    }
    return database_.run("COMMIT");
  };
  if (written()) return {};
  database_.run("ROLLBACK");
  return failed("A visit could not be counted");
}

Result<void> VisitStore::add_fetches(std::span<const souvenir::FetchNote> notes) {
  database_.retry();
  const auto written = [&] {
    if (!database_.run("BEGIN IMMEDIATE")) return false;
    // A note that could not be removed after counting comes again.
    Statement fetch(database_, "INSERT OR IGNORE INTO fetches (id, day) VALUES (?,?)");
    for (const souvenir::FetchNote& note : notes) {
      fetch.bind(note.id).bind(note.day);
      fetch.step();
      if (!fetch.done()) return false;
      fetch.reset();
    }
    return database_.run("COMMIT");
  };
  if (written()) return {};
  database_.run("ROLLBACK");
  return failed("Keepsakes opened on phones could not be counted");
}

Result<bool> VisitStore::clock_jumped(std::int64_t now) {
  database_.retry();
  // Of times close together, two are enough.
  std::vector<std::time_t> times;
  Statement near(database_,
                 "SELECT max(start) FROM visits WHERE start <= ?1 UNION ALL "
                 "SELECT min(start) FROM visits WHERE start > ?1 AND start <= ?2");
  near.bind(now - files::kDistrust).bind(now);
  while (near.step())
    if (!near.null(0)) times.push_back(near.integer(0));
  if (!near.done()) return failed("Visits could not be read");
  return files::clock_jumped(times, now);
}

Result<void> VisitStore::forget_before(const std::string& day) {
  database_.retry();
  bool gone = true;
  for (const char* sql :
       {"DELETE FROM visits WHERE day < ?", "DELETE FROM fetches WHERE day < ?"}) {
    Statement rows(database_, sql);
    rows.bind(day);
    rows.step();
    gone = gone && rows.done();
  }
  // Deleted data is still in the log until the log is emptied.
  if (gone && database_.run("PRAGMA wal_checkpoint(TRUNCATE)")) return {};
  return failed("Old visits could not be deleted");
}

}  // namespace onggi::store

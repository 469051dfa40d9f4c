#include "kiosk/store/visit_store.h"

#include <algorithm>
#include <utility>

#include "kiosk/files/json.h"
#include "kiosk/store/migrations.h"

namespace fs = std::filesystem;

namespace onggi::store {

namespace {

constexpr std::int64_t kQuarter = 15 * 60;  // s

Problem problem_of(const fs::path& file, const std::string& what, Trouble trouble,
                   const std::string& words) {
  switch (trouble) {
    case Trouble::in_use:
      return {file.string(), what + ": another onggi has it open.",
              "End the other one. Play goes on; visits of this one are not counted.", 1};
    case Trouble::unwritable:
      return {file.string(), what + ": " + words + ".",
              "Make room on the disk and the folder writable. Play goes on.", 1};
    case Trouble::damaged:
      return {file.string(), what + ": it is damaged (" + words + ").",
              "It is set aside at the next start. Play goes on.", 1};
    case Trouble::none:
    case Trouble::other:
      break;
  }
  return {file.string(), what + ": " + words + ".", "Play goes on. Please report it.", 1};
}

/// A file that cannot be read to its end, or lacks what its version has.
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
          "SELECT (SELECT count(value) FROM about) + (SELECT count(kept) FROM visits WHERE 0) + "
          "(SELECT count(body) FROM outbox WHERE 0) + (SELECT count(replay_hash) FROM keepsakes "
          "WHERE 0) + (SELECT count(value) FROM settings WHERE 0)")
      .has_value();
}

void set_aside(const fs::path& file, const std::string& stamp, std::vector<Problem>& remarks) {
  const std::string to = file.string() + ".damaged-" + stamp;
  std::error_code error;
  fs::rename(file, to, error);
  for (const char* tail : {"-wal", "-shm"}) {
    std::error_code ignored;
    fs::rename(file.string() + tail, to + tail, ignored);
  }
  remarks.push_back(
      {file.string(),
       "It was damaged and is set aside as " + fs::path(to).filename().string() +
           "; counting begins anew.",
       "Nothing needs doing. What it held may be rescued from there: sqlite3 FILE .recover.", 1});
}

files::Json body_of(const VisitRecord& v, std::int64_t start) {
  files::Json likeness;
  if (v.likeness) likeness = files::Json(*v.likeness);
  return files::Json::object({{"start", start},
                              {"day", v.day},
                              {"hour", v.hour},
                              {"vessel", v.vessel},
                              {"scene", v.scene},
                              {"language", v.language},
                              {"way", v.way},
                              {"reached", v.reached},
                              {"left", v.left},
                              {"ended", v.ended},
                              {"active_s", v.active_s},
                              {"throwing_s", v.throwing_s},
                              {"pots", v.pots},
                              {"likeness", likeness},
                              {"kept", v.kept}});
}

}  // namespace

Result<VisitStore> VisitStore::open(const fs::path& file, const std::string& stamp,
                                    std::vector<Problem>& remarks) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  for (const bool again : {false, true}) {
    Database database = Database::open(file, Database::Mode::own);
    if (!again && is_damaged(database)) {
      database = Database();
      set_aside(file, stamp, remarks);
      continue;
    }
    if (database.trouble() != Trouble::none)
      return tl::unexpected(
          problem_of(file, "Visits cannot be counted", database.trouble(), database.message()));
    const std::int64_t version = database.number("PRAGMA user_version").value_or(0);
    if (version > newest_version())
      return problem(file.string(),
                     "A newer onggi made it (version " + std::to_string(version) +
                         ", and this one knows " + std::to_string(newest_version()) + ").",
                     "Install the newer onggi again, or name another keepsake folder.", 1);
    if (migrate(database) && is_whole(database)) return VisitStore(file, std::move(database));
    if (again)
      return tl::unexpected(
          problem_of(file, "It cannot be brought forward", database.trouble(), database.message()));
    database = Database();
    set_aside(file, stamp, remarks);
  }
  return problem(file.string(), "Visits cannot be counted.", "Please report it.", 1);
}

tl::unexpected<Problem> VisitStore::failed(const std::string& what) const {
  return tl::unexpected(problem_of(file_, what, database_.trouble(), database_.message()));
}

Result<void> VisitStore::finish(Statement& statement, const std::string& what) {
  statement.step();
  if (!statement.done()) return failed(what);
  return {};
}

Result<void> VisitStore::add(std::span<const VisitRecord> visits) {
  const std::string what = "A visit could not be counted";
  if (!database_.run("BEGIN IMMEDIATE")) return failed(what);
  Statement visit(database_,
                  "INSERT INTO visits (start, day, hour, vessel, scene, language, way, reached, "
                  "left_at, ended, active_s, throwing_s, pots, likeness, kept) "
                  "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Statement outbox(database_, "INSERT INTO outbox (kind, body) VALUES ('visit', ?)");
  for (const VisitRecord& v : visits) {
    const std::int64_t start = v.start - ((v.start % kQuarter) + kQuarter) % kQuarter;
    visit.bind(start).bind(v.day).bind(std::int64_t{v.hour}).bind(v.vessel).bind(v.scene);
    visit.bind(v.language).bind(v.way).bind(v.reached).bind(v.left).bind(v.ended);
    visit.bind(v.active_s).bind(v.throwing_s).bind(std::int64_t{v.pots}).bind(v.likeness);
    visit.bind(std::int64_t{v.kept});
    outbox.bind(body_of(v, start).text(-1));
    for (Statement* const one : {&visit, &outbox}) {
      one->step();
      if (!one->done()) {
        const auto why = failed(what);
        database_.run("ROLLBACK");
        return why;
      }
      one->reset();
    }
  }
  if (database_.run("COMMIT")) return {};
  const auto why = failed(what);
  database_.run("ROLLBACK");
  return why;
}

Result<void> VisitStore::forget_before(const std::string& day) {
  Statement gone(database_, "DELETE FROM visits WHERE day < ?");
  gone.bind(day);
  return finish(gone, "Old visits could not be forgotten");
}

Result<void> VisitStore::keep(const KeepsakeRecord& k) {
  Statement put(database_, "INSERT OR REPLACE INTO keepsakes VALUES (?,?,?,?,?)");
  put.bind(k.name).bind(k.bytes).bind(k.kept_at).bind(k.expires_at).bind(k.replay_hash);
  return finish(put, "A keepsake could not be noted");
}

Result<void> VisitStore::dropped(const std::string& name) {
  Statement gone(database_, "DELETE FROM keepsakes WHERE name = ?");
  gone.bind(name);
  return finish(gone, "A keepsake that is gone could not be noted");
}

Result<std::vector<KeepsakeRecord>> VisitStore::due(std::int64_t now, std::int64_t quota) {
  Statement all(database_,
                "SELECT name, bytes, kept_at, expires_at, replay_hash FROM keepsakes "
                "ORDER BY kept_at DESC, name DESC");
  std::vector<KeepsakeRecord> gone;
  std::int64_t kept = 0;
  bool full = false;
  while (all.step()) {
    const KeepsakeRecord k{all.text(0), all.integer(1), all.integer(2), all.integer(3),
                           all.text(4)};
    const bool expired = k.expires_at != 0 && k.expires_at <= now;
    full = full || (!expired && kept + k.bytes > quota);
    if (expired || full)
      gone.push_back(k);
    else
      kept += k.bytes;
  }
  if (!all.done()) return failed("Keepsakes could not be looked through");
  std::reverse(gone.begin(), gone.end());
  return gone;
}

Result<std::string> VisitStore::setting(const std::string& key) {
  Statement get(database_, "SELECT value FROM settings WHERE key = ?");
  get.bind(key);
  if (get.step()) return get.text(0);
  if (!get.done()) return failed("A setting could not be read");
  return std::string();
}

Result<void> VisitStore::set(const std::string& key, const std::string& value) {
  Statement put(database_, "INSERT OR REPLACE INTO settings VALUES (?,?)");
  put.bind(key).bind(value);
  return finish(put, "A setting could not be kept");
}

Result<std::string> VisitStore::epoch() {
  Statement get(database_, "SELECT value FROM about WHERE key = 'epoch'");
  if (get.step()) return get.text(0);
  return failed("Its epoch could not be read");
}

Result<std::vector<OutboxRow>> VisitStore::outbox(int most) {
  Statement get(database_, "SELECT seq, kind, body FROM outbox ORDER BY seq LIMIT ?");
  get.bind(std::int64_t{most});
  std::vector<OutboxRow> rows;
  while (get.step()) rows.push_back({get.integer(0), get.text(1), get.text(2)});
  if (!get.done()) return failed("What a hub is to be told could not be read");
  return rows;
}

Result<void> VisitStore::acknowledged(std::int64_t seq) {
  Statement gone(database_, "DELETE FROM outbox WHERE seq <= ?");
  gone.bind(seq);
  return finish(gone, "What a hub was told could not be dropped");
}

}  // namespace onggi::store

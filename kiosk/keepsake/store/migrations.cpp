#include "kiosk/keepsake/store/migrations.h"

#include <array>
#include <string>

namespace onggi::store {

namespace {

// All of these have shipped: never change one, add the next.
constexpr std::array<const char*, 6> kSteps{
    // 1: visits. `left` is a word of SQL.
    R"sql(
CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
INSERT INTO about VALUES ('epoch', lower(hex(randomblob(16))));
CREATE TABLE visits (
  seq INTEGER PRIMARY KEY AUTOINCREMENT,
  start INTEGER NOT NULL,
  day TEXT NOT NULL,
  hour INTEGER NOT NULL,
  vessel TEXT NOT NULL,
  scene TEXT NOT NULL,
  language TEXT NOT NULL,
  way TEXT NOT NULL,
  reached TEXT NOT NULL,
  left_at TEXT NOT NULL,
  ended TEXT NOT NULL,
  active_s REAL NOT NULL,
  throwing_s REAL NOT NULL,
  pots INTEGER NOT NULL,
  likeness REAL,
  kept INTEGER NOT NULL
);
CREATE INDEX visits_by_day ON visits (day);
CREATE TABLE outbox (
  seq INTEGER PRIMARY KEY AUTOINCREMENT,
  kind TEXT NOT NULL,
  body TEXT NOT NULL
);
)sql",
    // 2: keepsakes and the replays in them.
    R"sql(
CREATE TABLE keepsakes (
  name TEXT PRIMARY KEY,
  bytes INTEGER NOT NULL,
  kept_at INTEGER NOT NULL,
  expires_at INTEGER NOT NULL,
  replay_hash TEXT NOT NULL
) WITHOUT ROWID;
CREATE INDEX keepsakes_by_age ON keepsakes (kept_at);
)sql",
    // 3: settings.
    R"sql(
CREATE TABLE settings (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
)sql",
    // 4: only visits. A second copy outlived deleted visits, keepsakes age by the dates in their
    // names, and no setting was ever stored here.
    R"sql(
DROP TABLE IF EXISTS outbox;
DROP TABLE IF EXISTS keepsakes;
DROP TABLE IF EXISTS settings;
)sql",
    // 5: keepsakes that were opened on a phone. The id is random and belongs to nothing else.
    R"sql(
CREATE TABLE fetches (id TEXT PRIMARY KEY, day TEXT NOT NULL) WITHOUT ROWID;
CREATE INDEX fetches_by_day ON fetches (day);
)sql",
    // 6: the visitor's task: a mission's id, or nothing.
    R"sql(
ALTER TABLE visits ADD COLUMN mission TEXT NOT NULL DEFAULT '';
)sql"};

}  // namespace

int newest_version() { return static_cast<int>(kSteps.size()); }

bool migrate(Database& database, int version) {
  const auto now = database.number("PRAGMA user_version");
  if (!now || *now > newest_version() || *now < 0) return false;
  for (auto n = static_cast<int>(*now); n < version; ++n) {
    const std::string step = std::string("BEGIN IMMEDIATE;") + kSteps[static_cast<std::size_t>(n)] +
                             "PRAGMA user_version=" + std::to_string(n + 1) + ";COMMIT;";
    if (database.run(step)) continue;
    database.run("ROLLBACK");
    return false;
  }
  return true;
}

}  // namespace onggi::store

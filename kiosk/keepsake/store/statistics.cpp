#include "kiosk/keepsake/store/statistics.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

#include "kiosk/ground/files/files_read.h"
#include "kiosk/keepsake/store/migrations.h"
#include "kiosk/keepsake/store/store_copy.h"
#include "kiosk/keepsake/store/visit_store.h"

namespace fs = std::filesystem;

namespace onggi::store {

namespace {

constexpr std::pair<const char*, const char*> kTables[] = {
    {"vessel", "vessel"},   {"mission", "mission"},
    {"reached", "reached"}, {"left", "left_at"},
    {"ended", "ended"},     {"language", "language"},
    {"way", "way"},         {"month", "substr(day, 1, 7)"},
    {"day", "day"},         {"hour", "printf('%02d', hour)"}};

constexpr const char* kSums =
    "count(*), total(kept), total(active_s), count(likeness), total(likeness)";
// Open ends: every day is after "" and before a letter.
constexpr const char* kOf = " FROM visits WHERE day >= ? AND day <= ? AND active_s >= ?";

class Reader {
 public:
  Reader(Database& database, const std::string& from, const std::string& to)
      : database_(database), from_(from), to_(to.empty() ? "z" : to) {}

  Statement ask(const std::string& columns, const std::string& tail = "") {
    Statement statement(database_, "SELECT " + columns + kOf + tail);
    statement.bind(from_).bind(to_).bind(Statistics::kBrief);
    return statement;
  }

  static Cell cell(const Statement& row, int at) {
    return {"",
            row.integer(at),
            static_cast<std::int64_t>(row.real(at + 1)),
            row.real(at + 2),
            row.integer(at + 3),
            row.real(at + 4)};
  }

  Table table(const std::string& name, const std::string& column) {
    Table out{name, {}};
    const bool in_order = name == "month" || name == "day" || name == "hour";
    Statement rows =
        ask(column + " AS name, " + kSums,
            " GROUP BY name ORDER BY " + std::string(in_order ? "name" : "2 DESC, name"));
    while (rows.step()) {
      out.cells.push_back(cell(rows, 1));
      out.cells.back().name = rows.text(0);
    }
    return out;
  }

  /// The mean of the middle two if their number is even.
  std::optional<double> median(std::int64_t visits) {
    if (visits == 0) return std::nullopt;
    Statement rows = ask("active_s", " ORDER BY active_s LIMIT " + std::to_string(2 - visits % 2) +
                                         " OFFSET " + std::to_string((visits - 1) / 2));
    double sum = 0.0;
    while (rows.step()) sum += rows.real(0);
    return sum / static_cast<double>(2 - visits % 2);
  }

  std::int64_t fetched() {
    Statement rows(database_, "SELECT count(*) FROM fetches WHERE day >= ? AND day <= ?");
    rows.bind(from_).bind(to_);
    return rows.step() ? rows.integer(0) : 0;
  }

  std::int64_t brief() {
    Statement rows(database_,
                   "SELECT count(*) FROM visits WHERE day >= ? AND day <= ? AND active_s < ?");
    rows.bind(from_).bind(to_).bind(Statistics::kBrief);
    return rows.step() ? rows.integer(0) : 0;
  }

 private:
  Database& database_;
  std::string from_, to_;
};

}  // namespace

Result<Statistics> read_statistics(Database& database, const std::string& from,
                                   const std::string& to) {
  Reader reader(database, from, to);
  Statistics s;
  s.from = from;
  s.to = to;
  if (Statement all = reader.ask(std::string(kSums) + ", total(pots), total(throwing_s)");
      all.step()) {
    s.all = Reader::cell(all, 0);
    s.pots = static_cast<std::int64_t>(all.real(5));
    s.throwing_s = all.real(6);
  }
  s.median_s = reader.median(s.all.visits);
  s.brief = reader.brief();
  s.fetched = reader.fetched();
  for (const auto& [name, column] : kTables) s.tables.push_back(reader.table(name, column));
  if (database.trouble() != Trouble::none)
    return problem("the store", "Its visits could not be read: " + database.message() + ".",
                   "Name the file that onggi run writes.");
  return s;
}

Result<Statistics> read_statistics(const std::string& file, const std::string& from,
                                   const std::string& to) {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    return problem(file, "There is no store of visits.",
                   "The first visit creates it beside the keepsakes. Name another store with "
                   "--store FILE.");
  if (::access(file.c_str(), R_OK) != 0 && errno == EACCES)
    return problem(file, "This user may not read what visitors did.",
                   "Type sudo before the command.", 1);
  // Note the file as read, so that no report overwrites it.
  struct stat read {};
  if (stat(file.c_str(), &read) == 0) files::note_read(read);
  const CopyFolder folder;
  if (folder.path().empty())
    return problem(fs::temp_directory_path(error).string(),
                   "No copy of the store can be made in the folder for temporary files.",
                   "Make room, or set TMPDIR.", 1);
  const fs::path copy = folder.path() / "copy";
  constexpr int kTries = 20;
  for (int n = 0; n < kTries; ++n) {
    if (n > 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (!copy_still(file, copy)) continue;
    Database database = Database::open(copy, Database::Mode::read);
    if (const auto version = database.number("PRAGMA user_version").value_or(0);
        version > newest_version())
      return tl::unexpected(newer_store(file, version, "Use the onggi that wrote it.", 2));
    if (database.trouble() == Trouble::none && migrate(database))
      return read_statistics(database, from, to);
    if (database.trouble() == Trouble::damaged || n + 1 == kTries)
      return problem(file,
                     "This onggi cannot read it as a store of visits: " + database.message() + ".",
                     "If it is damaged, onggi run sets it aside and starts a new one.");
  }
  return problem(file, "It is written to all the time, so no complete copy could be made.",
                 "Try again.", 1);
}

}  // namespace onggi::store

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace onggi::store {

/// The kinds of SQLite failure that need different reactions.
enum class Trouble : std::uint8_t {
  none,
  damaged,     ///< The file is not a database, or is damaged.
  unfit,       ///< A database with a missing or different table or column.
  in_use,      ///< Another program uses it.
  unwritable,  ///< A full or read-only disk, no permission, a failed write.
  other,
};

/// One connection to one SQLite file. No exceptions: the first failure stays in trouble(), whatever
/// succeeds or fails after it (a rollback, for example), until retry(). One thread; every call may
/// wait for the disk.
class Database {
 public:
  enum class Mode : std::uint8_t {
    /// Created if missing; write-ahead log, durable at each commit, and exclusive: two connections
    /// to one such file can damage it (SQLite before 3.51.3).
    own,
    read,  ///< Must exist and must not be written by anyone: a copy.
  };
  static Database open(const std::filesystem::path& file, Mode mode);

  Trouble trouble() const { return trouble_; }
  /// SQLite's message for it.
  const std::string& message() const { return message_; }
  /// Forgets a trouble that may have passed. Damage stays.
  void retry();

  /// Runs statements that return no rows. False: see trouble().
  bool run(const std::string& sql);
  /// The first number that `sql` returns; nothing if there is none or on failure.
  std::optional<std::int64_t> number(const std::string& sql);

 private:
  friend class Statement;
  struct Close {
    void operator()(sqlite3* db) const;
  };
  bool note(int code);

  std::unique_ptr<sqlite3, Close> db_;
  Trouble trouble_ = Trouble::none;
  std::string message_;
};

/// One statement of a database that outlives it: bind, then step.
class Statement {
 public:
  Statement(Database& database, const std::string& sql);

  /// Sets the next parameter, starting with the first; after reset() from the first again.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(const std::string& value);
  Statement& bind(const std::optional<double>& value);
  /// True if there is a row. False at the end and on a failure: see done().
  bool step();
  /// True if it ended without a failure.
  bool done() const { return done_; }
  /// Resets for the next set of parameters.
  void reset();

  /// Column `n`, from 0, of the row.
  std::int64_t integer(int n) const;
  double real(int n) const;
  std::string text(int n) const;
  bool null(int n) const;

 private:
  struct End {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database& database_;
  std::unique_ptr<sqlite3_stmt, End> statement_;
  int next_ = 1;
  bool done_ = false;
};

}  // namespace onggi::store

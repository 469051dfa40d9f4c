#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace onggi::store {

/// What SQLite says of a failure, as far as it matters for what to do next.
enum class Trouble : std::uint8_t {
  none,
  damaged,     ///< What is in the file is no database, or not the one that was written.
  unfit,       ///< A database, but a table or a column is not there, or is another one.
  in_use,      ///< Another program has it.
  unwritable,  ///< A full or read-only disk, no permission, a failed write.
  other,
};

/// One connection to one SQLite file. No exceptions: the first failure stays in trouble(), whatever
/// succeeds or fails after it (a rollback, say), until retry(). Any one thread; every call may wait
/// for the disk.
class Database {
 public:
  enum class Mode : std::uint8_t {
    own,   ///< Made where it is missing; write-ahead log, durable at each commit, and nobody else
           ///< gets in: two connections to one such file can damage it (SQLite before 3.51.3).
    read,  ///< Must be there, and nobody may be writing it: a copy.
  };
  static Database open(const std::filesystem::path& file, Mode mode);

  Trouble trouble() const { return trouble_; }
  /// SQLite's own words for it.
  const std::string& message() const { return message_; }
  /// Forgets a trouble that may have passed. Damage does not pass.
  void retry();

  /// Statements that give no rows, one after the other. False: see trouble().
  bool run(const std::string& sql);
  /// The first figure that `sql` gives; nothing where it gives none or fails.
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

  /// The next parameter, from the first on; after reset() from the first again.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(const std::string& value);
  Statement& bind(const std::optional<double>& value);
  /// True where there is a row. False at the end and on a failure: see done().
  bool step();
  /// It came to its end without a failure.
  bool done() const { return done_; }
  /// For the next row of parameters.
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

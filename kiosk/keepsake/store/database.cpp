#include "kiosk/keepsake/store/database.h"

#include <sqlite3.h>

namespace onggi::store {

namespace {

Trouble trouble_of(int code) {
  switch (code & 0xff) {
    case SQLITE_OK:
    case SQLITE_ROW:
    case SQLITE_DONE:
      return Trouble::none;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return Trouble::damaged;
    case SQLITE_ERROR:
    case SQLITE_SCHEMA:
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
      return Trouble::unfit;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return Trouble::in_use;
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return Trouble::unwritable;
    default:
      return Trouble::other;
  }
}

}  // namespace

void Database::Close::operator()(sqlite3* db) const { sqlite3_close_v2(db); }

bool Database::note(int code) {
  const Trouble now = trouble_of(code);
  if (now == Trouble::none) return true;
  const bool worse = now == Trouble::damaged && trouble_ != Trouble::damaged;
  if (trouble_ != Trouble::none && !worse) return false;
  trouble_ = now;
  message_ = db_ != nullptr ? sqlite3_errmsg(db_.get()) : sqlite3_errstr(code);
  return false;
}

void Database::retry() {
  if (trouble_ != Trouble::damaged) trouble_ = Trouble::none;
}

Database Database::open(const std::filesystem::path& file, Mode mode) {
  Database database;
  sqlite3* db = nullptr;
  const int flags =
      mode == Mode::own ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READWRITE;
  const int code = sqlite3_open_v2(file.c_str(), &db, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  database.db_.reset(db);
  if (!database.note(code)) return database;
  sqlite3_extended_result_codes(db, 1);
  // Lock exclusively before using the log: no second connection can then begin, and no shared
  // memory is needed.
  if (mode == Mode::own)
    database.run(
        "PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL;"
        "PRAGMA secure_delete=ON; BEGIN IMMEDIATE; COMMIT;");
  return database;
}

bool Database::run(const std::string& sql) {
  return note(sqlite3_exec(db_.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

std::optional<std::int64_t> Database::number(const std::string& sql) {
  Statement statement(*this, sql);
  if (!statement.step()) return std::nullopt;
  return statement.integer(0);
}

void Statement::End::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  database.note(sqlite3_prepare_v2(database.db_.get(), sql.c_str(), -1, &statement, nullptr));
  statement_.reset(statement);
}

Statement& Statement::bind(std::int64_t value) {
  if (statement_) sqlite3_bind_int64(statement_.get(), next_++, value);
  return *this;
}

Statement& Statement::bind(double value) {
  if (statement_) sqlite3_bind_double(statement_.get(), next_++, value);
  return *this;
}

Statement& Statement::bind(const std::string& value) {
  if (statement_)
    sqlite3_bind_text(statement_.get(), next_++, value.data(), static_cast<int>(value.size()),
                      SQLITE_TRANSIENT);
  return *this;
}

Statement& Statement::bind(const std::optional<double>& value) {
  if (value) return bind(*value);
  if (statement_) sqlite3_bind_null(statement_.get(), next_++);
  return *this;
}

bool Statement::step() {
  done_ = false;
  if (!statement_) return false;
  const int code = sqlite3_step(statement_.get());
  done_ = code == SQLITE_DONE;
  return database_.note(code) && code == SQLITE_ROW;
}

void Statement::reset() {
  if (!statement_) return;
  sqlite3_reset(statement_.get());
  next_ = 1;
}

std::int64_t Statement::integer(int n) const { return sqlite3_column_int64(statement_.get(), n); }
double Statement::real(int n) const { return sqlite3_column_double(statement_.get(), n); }
bool Statement::null(int n) const {
  return sqlite3_column_type(statement_.get(), n) == SQLITE_NULL;
}

std::string Statement::text(int n) const {
  const auto* at = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), n));
  return at == nullptr
             ? std::string()
             : std::string(at, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), n)));
}

}  // namespace onggi::store

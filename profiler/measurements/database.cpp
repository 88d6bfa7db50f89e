#include "profiler/measurements/database.h"

#include <sqlite3.h>

#include <limits>

#include "runtime/base/check.h"

namespace reprise {

namespace {

constexpr int kBusyTimeoutMs = 10'000;

Error storeError(sqlite3* handle, int status, const std::filesystem::path& path) {
  const std::string reason = handle ? sqlite3_errmsg(handle) : sqlite3_errstr(status);
  const std::string file = "the store " + path.string();
  switch (status & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorKind::kMachine, "store.unwritable",
              file + " is held by another run for more than 10 s; wait for it, or use another output directory", {}};
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
    case SQLITE_NOMEM:
      return {ErrorKind::kMachine, "store.unwritable",
              file + " cannot be written: " + reason + "; what was measured before is kept", {}};
    default:
      return {ErrorKind::kMachine, "store.corrupt",
              file + " is damaged or no store of Reprise: " + reason + "; move it away to measure anew", {}};
  }
}

}  // namespace

void Database::Closer::operator()(sqlite3* handle) const {
  sqlite3_close_v2(handle);
}

void Statement::Finalizer::operator()(sqlite3_stmt* handle) const {
  sqlite3_finalize(handle);
}

Result<Database> Database::open(const std::filesystem::path& path) {
  std::error_code unknown;
  const std::filesystem::file_type type = std::filesystem::status(path, unknown).type();
  const bool opens = type == std::filesystem::file_type::not_found || type == std::filesystem::file_type::regular || type == std::filesystem::file_type::directory;
  if (!opens && !unknown)  // SQLite itself tells of a folder
    return Error{ErrorKind::kInput, "file.not_regular", "the store '" + path.string() + "' is no regular file; move it away to measure anew", {path.string(), 0, 0}};
  sqlite3* handle = nullptr;
  const int status =
      sqlite3_open_v2(path.c_str(), &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_EXRESCODE, nullptr);
  Database database(handle, path);
  if (status != SQLITE_OK) return storeError(handle, status, path);
  // SQLite opens for reading what it may not write.
  if (sqlite3_db_readonly(handle, "main") == 1) return storeError(nullptr, SQLITE_READONLY, path);
  sqlite3_busy_timeout(handle, kBusyTimeoutMs);
  return database;
}

Result<void> Database::execute(const std::string& sql) {
  const int status = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (status != SQLITE_OK) return storeError(handle_.get(), status, path_);
  return {};
}

Result<Statement> Database::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  const int status =
      sqlite3_prepare_v2(handle_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  Statement owned(statement, path_);
  if (status != SQLITE_OK) return storeError(handle_.get(), status, path_);
  return owned;
}

Result<std::int64_t> Database::readNumber(const std::string& sql) const {
  REPRISE_ASSIGN(Statement statement, prepare(sql));
  REPRISE_ASSIGN(const bool has_row, statement.step());
  return has_row ? statement.number(0) : std::int64_t{0};
}

std::int64_t Database::lastInsertedRow() const {
  return sqlite3_last_insert_rowid(handle_.get());
}

void Statement::bind(int parameter, std::int64_t value) {
  const int status = sqlite3_bind_int64(handle_.get(), parameter + 1, value);
  REPRISE_CHECK(status == SQLITE_OK, status, parameter);
}

void Statement::bind(int parameter, double value) {
  const int status = sqlite3_bind_double(handle_.get(), parameter + 1, value);
  REPRISE_CHECK(status == SQLITE_OK, status, parameter);
}

void Statement::bind(int parameter, std::string_view value) {
  // A null pointer would bind NULL.
  const char* bytes = value.data() ? value.data() : "";
  const int status =
      sqlite3_bind_text64(handle_.get(), parameter + 1, bytes, value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  REPRISE_CHECK(status == SQLITE_OK, status, parameter);
}

Result<bool> Statement::step() {
  const int status = sqlite3_step(handle_.get());
  if (status == SQLITE_ROW) return true;
  sqlite3* database = sqlite3_db_handle(handle_.get());
  Result<bool> result = false;
  if (status != SQLITE_DONE) result = storeError(database, status, path_);
  sqlite3_reset(handle_.get());
  return result;
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const {
  if (sqlite3_column_type(handle_.get(), column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(handle_.get(), column);
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return bytes ? std::string(bytes, sqlite3_column_bytes(handle_.get(), column)) : std::string();
}

Result<Transaction> Transaction::begin(Database* database) {
  REPRISE_TRY(database->execute("BEGIN IMMEDIATE"));
  return Transaction(database);
}

Result<void> Transaction::commit() {
  // A commit that fails leaves the transaction open for the destructor to roll back.
  REPRISE_TRY(database_->execute("COMMIT"));
  database_ = nullptr;
  return {};
}

Transaction::~Transaction() {
  // After a full disk SQLite has rolled back by itself and this is refused, which is as well.
  if (database_) (void)database_->execute("ROLLBACK");
}

}  // namespace reprise

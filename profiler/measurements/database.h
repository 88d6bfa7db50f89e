// SQLite with owned handles and Results instead of codes. Knows nothing of what is stored.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace reprise {

class Statement;

// An open database file. Errors of all calls (kMachine): store.unwritable (locked for longer than 10 s, disk full, no
// permission), store.corrupt (not a database, or damaged).
class Database {
 public:
  static Result<Database> open(const std::filesystem::path& path);

  Result<void> execute(const std::string& sql);
  Result<Statement> prepare(std::string_view sql) const;
  Result<std::int64_t> readNumber(const std::string& sql) const;  // first column of the first row; 0 without a row
  std::int64_t lastInsertedRow() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  Database(sqlite3* handle, std::filesystem::path path) : handle_(handle), path_(std::move(path)) {}

  std::unique_ptr<sqlite3, Closer> handle_;
  std::filesystem::path path_;
};

// A prepared statement; must not outlive its database. Parameters and columns count from 0.
class Statement {
 public:
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, double value);  // NaN becomes NULL
  void bind(int parameter, std::string_view value);
  // Runs to the next row: true if there is one. After the last row the statement can be bound and run again.
  Result<bool> step();
  std::int64_t number(int column) const;
  double real(int column) const;  // NULL is NaN
  std::string text(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* handle) const;
  };
  Statement(sqlite3_stmt* handle, std::filesystem::path path) : handle_(handle), path_(std::move(path)) {}

  std::unique_ptr<sqlite3_stmt, Finalizer> handle_;
  std::filesystem::path path_;
  friend class Database;
};

// Takes the write lock at once, so that what is read inside stays true until the commit. Rolls back unless committed.
class Transaction {
 public:
  static Result<Transaction> begin(Database* database);
  Result<void> commit();
  Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  Transaction& operator=(Transaction&&) = delete;
  ~Transaction();

 private:
  explicit Transaction(Database* database) : database_(database) {}
  Database* database_;
};

}  // namespace reprise

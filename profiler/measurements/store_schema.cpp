#include "profiler/measurements/store_schema.h"

namespace reprise {

namespace {

// error_series, time_series and failures say that a series is there, even one without rows.
constexpr const char* kTables = R"sql(
CREATE TABLE series (
  id INTEGER PRIMARY KEY,
  variant_hash TEXT NOT NULL, shader_hash TEXT NOT NULL, scenario_hash TEXT NOT NULL, session TEXT NOT NULL,
  device TEXT NOT NULL, driver TEXT NOT NULL, width INTEGER NOT NULL, height INTEGER NOT NULL,
  seed INTEGER NOT NULL, period_frames INTEGER NOT NULL, tool_version TEXT NOT NULL,
  UNIQUE (variant_hash, shader_hash, scenario_hash, session, device, driver, width, height, seed, period_frames,
          tool_version));
CREATE TABLE error_series (series INTEGER PRIMARY KEY REFERENCES series);
CREATE TABLE error_rows (
  series INTEGER NOT NULL REFERENCES series, row INTEGER NOT NULL, frame INTEGER NOT NULL,
  covered INTEGER NOT NULL, hits INTEGER NOT NULL, misses INTEGER NOT NULL,
  shaded_hits INTEGER NOT NULL, shaded_misses INTEGER NOT NULL, nonfinite INTEGER NOT NULL,
  spoiled INTEGER NOT NULL,
  PRIMARY KEY (series, row)) WITHOUT ROWID;
CREATE TABLE error_values (
  series INTEGER NOT NULL REFERENCES series, row INTEGER NOT NULL, metric TEXT NOT NULL, value REAL, tiles TEXT,
  PRIMARY KEY (series, row, metric)) WITHOUT ROWID;
CREATE TABLE time_series (
  series INTEGER NOT NULL REFERENCES series, run_id TEXT NOT NULL, PRIMARY KEY (series, run_id)) WITHOUT ROWID;
CREATE TABLE time_rows (
  id INTEGER PRIMARY KEY, series INTEGER NOT NULL REFERENCES series, run_id TEXT NOT NULL,
  pair INTEGER NOT NULL, frame INTEGER NOT NULL, gpu_ms REAL, wall_ms REAL, cpu_ms REAL);
CREATE INDEX time_rows_of_series ON time_rows (series, id);
CREATE TABLE failures (series INTEGER PRIMARY KEY REFERENCES series, code TEXT NOT NULL, message TEXT NOT NULL);
CREATE TABLE texts (key TEXT PRIMARY KEY, text TEXT NOT NULL) WITHOUT ROWID;
)sql";

Error corrupt(const Database& database, const std::string& found) {
  return {ErrorKind::kMachine, "store.corrupt",
          "the store " + database.path().string() + " " + found + "; move it away to measure anew", {}};
}

Result<void> checkVersion(const Database& database) {
  REPRISE_ASSIGN(const std::int64_t application, database.readNumber("PRAGMA application_id"));
  if (application != kStoreApplicationId) return corrupt(database, "is a database of another program");
  REPRISE_ASSIGN(const std::int64_t version, database.readNumber("PRAGMA user_version"));
  if (version > kStoreVersion) {
    return Error{ErrorKind::kInput, "store.version",
                 "the store " + database.path().string() + " has version " + std::to_string(version) +
                     ", this Reprise knows up to " + std::to_string(kStoreVersion) +
                     "; use the newer Reprise that made it, or another output directory",
                 {}};
  }
  if (version != kStoreVersion) return corrupt(database, "has the unknown version " + std::to_string(version));
  return {};
}

Result<void> checkContent(const Database& database) {
  REPRISE_ASSIGN(Statement check, database.prepare("PRAGMA quick_check(1)"));
  REPRISE_ASSIGN(const bool has_row, check.step());
  const std::string found = has_row ? check.text(0) : "no answer";
  if (found != "ok") return corrupt(database, "is damaged (" + found + ")");
  return {};
}

Result<bool> isEmpty(const Database& database) {
  REPRISE_ASSIGN(const std::int64_t tables, database.readNumber("SELECT count(*) FROM sqlite_master"));
  REPRISE_ASSIGN(const std::int64_t application, database.readNumber("PRAGMA application_id"));
  return tables == 0 && application == 0;
}

}  // namespace

Result<void> prepareSchema(Database* database) {
  REPRISE_ASSIGN(const bool looks_empty, isEmpty(*database));
  if (looks_empty) {
    REPRISE_ASSIGN(Transaction transaction, Transaction::begin(database));
    // Another run may have made the tables while this one waited for the lock.
    REPRISE_ASSIGN(const bool empty, isEmpty(*database));
    if (empty) {
      REPRISE_TRY(database->execute(kTables));
      REPRISE_TRY(database->execute("PRAGMA application_id = " + std::to_string(kStoreApplicationId)));
      REPRISE_TRY(database->execute("PRAGMA user_version = " + std::to_string(kStoreVersion)));
      return transaction.commit();
    }
  }
  REPRISE_TRY(checkVersion(*database));
  return checkContent(*database);
}

}  // namespace reprise

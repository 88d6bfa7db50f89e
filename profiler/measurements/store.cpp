#include "profiler/measurements/store.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "profiler/measurements/database.h"
#include "profiler/measurements/store_schema.h"

namespace reprise {

namespace {

constexpr std::string_view kWhereKey =
    " WHERE variant_hash = ? AND shader_hash = ? AND scenario_hash = ? AND session = ? AND device = ? AND driver = ?"
    " AND width = ? AND height = ? AND seed = ? AND period_frames = ? AND tool_version = ?";

void bindKey(const SeriesKey& key, Statement* statement) {
  int parameter = 0;
  for (const std::string* text :
       {&key.variant_hash, &key.shader_hash, &key.scenario_hash, &key.session, &key.device, &key.driver}) {
    statement->bind(parameter++, std::string_view(*text));
  }
  for (const std::uint32_t number : {key.width, key.height, key.seed, key.period_frames}) {
    statement->bind(parameter++, std::int64_t{number});
  }
  statement->bind(parameter, std::string_view(key.tool_version));
}

Result<void> runOnce(Statement* statement) {
  REPRISE_TRY(statement->step());
  return {};
}

Result<std::optional<std::int64_t>> findSeries(const Database& database, const SeriesKey& key) {
  REPRISE_ASSIGN(Statement find, database.prepare("SELECT id FROM series" + std::string(kWhereKey)));
  bindKey(key, &find);
  REPRISE_ASSIGN(const bool found, find.step());
  return found ? std::optional(find.number(0)) : std::nullopt;
}

Result<std::int64_t> findOrAddSeries(Database* database, const SeriesKey& key) {
  REPRISE_ASSIGN(const std::optional<std::int64_t> found, findSeries(*database, key));
  if (found) return *found;
  REPRISE_ASSIGN(Statement add, database->prepare("INSERT INTO series VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
  bindKey(key, &add);
  REPRISE_TRY(runOnce(&add));
  return database->lastInsertedRow();
}

Result<bool> hasErrors(const Database& database, std::int64_t series) {
  REPRISE_ASSIGN(Statement find, database.prepare("SELECT 1 FROM error_series WHERE series = ?"));
  find.bind(0, series);
  return find.step();
}

// Numbers between blanks; one blank where there are none, as an empty text stands for a metric without tiles.
std::string textOfTiles(const std::vector<std::uint16_t>& tiles) {
  std::string text = " ";
  for (const std::uint16_t tile : tiles) text += std::to_string(tile) + " ";
  return text;
}

Result<std::optional<std::vector<std::uint16_t>>> tilesFrom(const Database& database, const std::string& text) {
  if (text.empty()) return std::optional<std::vector<std::uint16_t>>();
  std::vector<std::uint16_t> tiles;
  const char* at = text.data() + 1;
  const char* const end = text.data() + text.size();
  while (at < end) {
    std::uint16_t tile = 0;
    const auto [next, failure] = std::from_chars(at, end, tile);
    if (failure != std::errc() || next == end || *next != ' ')
      return Error{ErrorKind::kMachine, "store.corrupt", "the store " + database.path().string() + " holds tiles that are no numbers; move it away to measure anew", {}};
    tiles.push_back(tile);
    at = next + 1;
  }
  return std::optional(std::move(tiles));
}

Result<void> insertErrorRows(Database* database, std::int64_t series, const std::vector<ErrorRow>& rows) {
  REPRISE_ASSIGN(Statement mark, database->prepare("INSERT INTO error_series VALUES (?)"));
  mark.bind(0, series);
  REPRISE_TRY(runOnce(&mark));
  REPRISE_ASSIGN(Statement add_row, database->prepare("INSERT INTO error_rows VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
  REPRISE_ASSIGN(Statement add_value, database->prepare("INSERT INTO error_values VALUES (?, ?, ?, ?, ?)"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ErrorRow& row = rows[i];
    const auto index = static_cast<std::int64_t>(i);
    int parameter = 0;
    for (const std::int64_t number : {series, index, std::int64_t{row.frame}}) add_row.bind(parameter++, number);
    // Counts beyond 2^63 come back whole from the two's complement.
    for (const std::uint64_t count :
         {row.covered, row.hits, row.misses, row.shaded_hits, row.shaded_misses, row.nonfinite, row.spoiled}) {
      add_row.bind(parameter++, static_cast<std::int64_t>(count));
    }
    REPRISE_TRY(runOnce(&add_row));
    for (const auto& [metric, value] : row.errors) {
      add_value.bind(0, series);
      add_value.bind(1, index);
      add_value.bind(2, std::string_view(metric));
      add_value.bind(3, value);
      const auto tiles = row.tiles.find(metric);
      add_value.bind(4, std::string_view(tiles == row.tiles.end() ? "" : textOfTiles(tiles->second)));
      REPRISE_TRY(runOnce(&add_value));
    }
  }
  return {};
}

Result<std::vector<ErrorRow>> readErrorRows(const Database& database, std::int64_t series) {
  REPRISE_ASSIGN(Statement read, database.prepare("SELECT frame, covered, hits, misses, shaded_hits, shaded_misses, nonfinite, spoiled"
                                                  " FROM error_rows WHERE series = ? ORDER BY row"));
  read.bind(0, series);
  std::vector<ErrorRow> rows;
  while (true) {
    REPRISE_ASSIGN(const bool has_row, read.step());
    if (!has_row) break;
    const auto count = [&](int column) { return static_cast<std::uint64_t>(read.number(column)); };
    rows.push_back({static_cast<int>(read.number(0)), count(1), count(2), count(3), count(4), count(5), count(6), count(7), {}});
  }
  REPRISE_ASSIGN(Statement values, database.prepare("SELECT row, metric, value, tiles FROM error_values WHERE series = ?"));
  values.bind(0, series);
  while (true) {
    REPRISE_ASSIGN(const bool has_row, values.step());
    if (!has_row) break;
    const std::int64_t row = values.number(0);
    if (row < 0 || row >= static_cast<std::int64_t>(rows.size())) {
      return Error{ErrorKind::kMachine, "store.corrupt",
                   "the store " + database.path().string() + " holds an error value without its row", {}};
    }
    rows[row].errors[values.text(1)] = values.real(2);
    REPRISE_ASSIGN(auto tiles, tilesFrom(database, values.text(3)));
    if (tiles) rows[row].tiles[values.text(1)] = std::move(*tiles);
  }
  return rows;
}

TimeRow timeRowAt(const Statement& read) {
  return {read.text(0), static_cast<int>(read.number(1)), static_cast<int>(read.number(2)), read.real(3), read.real(4),
          read.real(5)};
}

Result<std::vector<TimeRow>> readTimeRows(const Database& database, std::int64_t series) {
  REPRISE_ASSIGN(Statement read, database.prepare("SELECT run_id, pair, frame, gpu_ms, wall_ms, cpu_ms FROM time_rows"
                                                  " WHERE series = ? ORDER BY id"));
  read.bind(0, series);
  std::vector<TimeRow> rows;
  while (true) {
    REPRISE_ASSIGN(const bool has_row, read.step());
    if (!has_row) return rows;
    rows.push_back(timeRowAt(read));
  }
}

Result<void> insertTimeRows(Database* database, std::int64_t series, const std::vector<TimeRow>& rows) {
  REPRISE_ASSIGN(Statement mark, database->prepare("INSERT OR IGNORE INTO time_series VALUES (?, ?)"));
  REPRISE_ASSIGN(Statement add, database->prepare("INSERT INTO time_rows VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"));
  for (const TimeRow& row : rows) {
    mark.bind(0, series);
    mark.bind(1, std::string_view(row.run_id));
    REPRISE_TRY(runOnce(&mark));
    add.bind(0, series);
    add.bind(1, std::string_view(row.run_id));
    add.bind(2, std::int64_t{row.pair});
    add.bind(3, std::int64_t{row.frame});
    add.bind(4, row.gpu_ms);
    add.bind(5, row.wall_ms);
    add.bind(6, row.cpu_ms);
    REPRISE_TRY(runOnce(&add));
  }
  return {};
}

std::vector<TimeRow> rowsOfRun(const std::vector<TimeRow>& rows, const std::string& run_id) {
  std::vector<TimeRow> of_run;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(of_run),
               [&](const TimeRow& row) { return row.run_id == run_id; });
  return of_run;
}

// The rows whose run is not there yet. A run that is there must have the same rows: else pairs of two runs would mix.
Result<std::vector<TimeRow>> newTimeRows(const Database& database, std::int64_t series,
                                         const std::vector<TimeRow>& rows) {
  REPRISE_ASSIGN(const std::vector<TimeRow> stored, readTimeRows(database, series));
  std::vector<TimeRow> fresh;
  for (const TimeRow& row : rows) {
    const std::vector<TimeRow> stored_run = rowsOfRun(stored, row.run_id);
    if (stored_run.empty()) {
      fresh.push_back(row);
    } else if (stored_run != rowsOfRun(rows, row.run_id)) {
      return Error{ErrorKind::kMeasurement, "store.run_reused",
                   "other times were stored under the run id " + row.run_id + " before; give every timing job its own", {}};
    }
  }
  return fresh;
}

}  // namespace

struct Store::State {
  Database database;
};

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

const std::filesystem::path& Store::path() const { return state_->database.path(); }

Result<Store> Store::open(const std::filesystem::path& path) {
  std::error_code made;  // a directory that cannot be made shows in opening the file
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), made);
  REPRISE_ASSIGN(Database database, Database::open(path));
  REPRISE_TRY(prepareSchema(&database));
  return Store(std::make_unique<State>(State{std::move(database)}));
}

Result<void> Store::appendErrors(const SeriesKey& key, const std::vector<ErrorRow>& rows) {
  Database* database = &state_->database;
  REPRISE_ASSIGN(Transaction transaction, Transaction::begin(database));
  REPRISE_ASSIGN(const std::int64_t series, findOrAddSeries(database, key));
  REPRISE_ASSIGN(const bool present, hasErrors(*database, series));
  if (present) return {};
  REPRISE_TRY(insertErrorRows(database, series, rows));
  return transaction.commit();
}

Result<void> Store::appendTimes(const SeriesKey& key, const std::vector<TimeRow>& rows) {
  Database* database = &state_->database;
  REPRISE_ASSIGN(Transaction transaction, Transaction::begin(database));
  REPRISE_ASSIGN(const std::int64_t series, findOrAddSeries(database, key));
  REPRISE_ASSIGN(const std::vector<TimeRow> fresh, newTimeRows(*database, series, rows));
  if (fresh.empty()) return {};
  REPRISE_TRY(insertTimeRows(database, series, fresh));
  return transaction.commit();
}

Result<void> Store::appendFailure(const SeriesKey& key, const FailureRow& failure) {
  Database* database = &state_->database;
  REPRISE_ASSIGN(Transaction transaction, Transaction::begin(database));
  REPRISE_ASSIGN(const std::int64_t series, findOrAddSeries(database, key));
  REPRISE_ASSIGN(Statement add, database->prepare("INSERT OR IGNORE INTO failures VALUES (?, ?, ?)"));
  add.bind(0, series);
  add.bind(1, std::string_view(failure.code));
  add.bind(2, std::string_view(failure.message));
  REPRISE_TRY(runOnce(&add));
  return transaction.commit();
}

Result<void> Store::putText(const std::string& key, const std::string& text) {
  REPRISE_ASSIGN(Transaction transaction, Transaction::begin(&state_->database));
  REPRISE_ASSIGN(Statement add, state_->database.prepare("INSERT OR IGNORE INTO texts VALUES (?, ?)"));
  add.bind(0, std::string_view(key));
  add.bind(1, std::string_view(text));
  REPRISE_TRY(runOnce(&add));
  return transaction.commit();
}

// Rows never change and come whole, so that the statements of a reading call need no transaction around them.
Result<std::optional<std::vector<ErrorRow>>> Store::errors(const SeriesKey& key) const {
  const Database& database = state_->database;
  REPRISE_ASSIGN(const std::optional<std::int64_t> series, findSeries(database, key));
  if (!series) return std::optional<std::vector<ErrorRow>>();
  REPRISE_ASSIGN(const bool present, hasErrors(database, *series));
  if (!present) return std::optional<std::vector<ErrorRow>>();
  REPRISE_ASSIGN(std::vector<ErrorRow> rows, readErrorRows(database, *series));
  return std::optional(std::move(rows));
}

Result<std::vector<TimeRow>> Store::times(const SeriesKey& key) const {
  REPRISE_ASSIGN(const std::optional<std::int64_t> series, findSeries(state_->database, key));
  if (!series) return std::vector<TimeRow>();
  return readTimeRows(state_->database, *series);
}

Result<std::optional<FailureRow>> Store::failure(const SeriesKey& key) const {
  REPRISE_ASSIGN(const std::optional<std::int64_t> series, findSeries(state_->database, key));
  if (!series) return std::optional<FailureRow>();
  REPRISE_ASSIGN(Statement find, state_->database.prepare("SELECT code, message FROM failures WHERE series = ?"));
  find.bind(0, *series);
  REPRISE_ASSIGN(const bool found, find.step());
  return found ? std::optional(FailureRow{find.text(0), find.text(1)}) : std::nullopt;
}

Result<std::optional<std::string>> Store::text(const std::string& key) const {
  REPRISE_ASSIGN(Statement find, state_->database.prepare("SELECT text FROM texts WHERE key = ?"));
  find.bind(0, std::string_view(key));
  REPRISE_ASSIGN(const bool found, find.step());
  return found ? std::optional(find.text(0)) : std::nullopt;
}

}  // namespace reprise

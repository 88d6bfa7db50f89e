// The store of measurements: one SQLite file, append-only, keyed by SeriesKey. A series is appended in one transaction, so
// that a run killed at any moment leaves whole series only and a resumed run goes on where it stopped. The journal is a
// rollback journal: the file is all there is between two writes, and processes on any file system may share it.
// All calls have the errors of opening; a failed call has changed nothing. NaN comes back as NaN. One thread per Store.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "profiler/measurements/row.h"
#include "runtime/base/result.h"

namespace reprise {

// A variant that gave no measurement: it crashed, hung or lost the device.
struct FailureRow {
  std::string code;     // "worker.crashed", "worker.timeout", "device.lost"
  std::string message;
  bool operator==(const FailureRow&) const = default;
};

class Store {
 public:
  // Opens or makes the file; waits up to 10 s for another writer. Errors: store.unwritable, store.corrupt (kMachine),
  // store.version (made by a newer version; kInput), file.not_regular (kInput).
  static Result<Store> open(const std::filesystem::path& path);
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  // A series that is there already is left as it is (append-only): the call succeeds and changes nothing.
  Result<void> appendErrors(const SeriesKey& key, const std::vector<ErrorRow>& rows);
  // Several runs may be appended; the run_id tells them apart and must be given to one timing job only. A run that is there
  // already is left as it is; if its times differ: store.run_reused (kMeasurement).
  Result<void> appendTimes(const SeriesKey& key, const std::vector<TimeRow>& rows);
  Result<void> appendFailure(const SeriesKey& key, const FailureRow& failure);
  // A value by name with the key's content, for what is neither error nor time (ranges seen in training). The first value
  // put under a name stays.
  Result<void> putText(const std::string& key, const std::string& text);

  Result<std::optional<std::vector<ErrorRow>>> errors(const SeriesKey& key) const;
  Result<std::vector<TimeRow>> times(const SeriesKey& key) const;   // all runs, in the order appended
  Result<std::optional<FailureRow>> failure(const SeriesKey& key) const;
  Result<std::optional<std::string>> text(const std::string& key) const;
  const std::filesystem::path& path() const;

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace reprise

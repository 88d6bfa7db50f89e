// Series of measurements, from the store where they are there already, else from a supervised worker (stage 7).
//
// The unit of work is one job: one session, several entries. What a job brings is appended to the store entry by entry, so
// that a run that was killed goes on where it stopped and ends with the rows of an unbroken one, in all columns but times
// (law 9). An entry that crashes or hangs the worker is a recorded failure of that entry; the others are measured without it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "profiler/measurements/store.h"
#include "profiler/session/job.h"

namespace reprise {

// One thing to measure: a package on disk, its content hash, and the period to play it with.
struct SeriesRequest {
  std::string package_dir;
  std::string variant_hash;
  std::uint32_t period_frames = 1;
  bool operator==(const SeriesRequest&) const = default;
};

struct Measuring {
  Store* store = nullptr;
  SeriesKey base;                // all fields but variant_hash, session and period_frames
  std::string scenario_path;
  std::string original_dir;      // package of the original
  std::string device;            // as ContextOptions::device
  std::vector<std::string> metrics;
  SupervisorOptions supervisor;
  std::function<void(const JobProgress&)> progress;
};

// By request: rows, or why there are none.
struct ErrorSeries {
  std::vector<ErrorRow> rows;
  std::optional<FailureRow> failure;
};
struct TimeSeries {
  std::vector<TimeRow> rows;
  std::optional<FailureRow> failure;
};

// Errors of a session over `frames` frames (0: the session's). Errors: kInterrupted, kMachine; a failing entry is no error.
Result<std::vector<ErrorSeries>> measureErrors(const Measuring& measuring, const std::string& session,
                                               const std::vector<SeriesRequest>& requests, int frames);

// Times of all requests alternating in one run, so that they pair: rows[r].pair == r for every request. A complete earlier run of
// the same requests is taken from the store unless `anew`.
struct TimingPlan {
  std::string session;
  int rounds = 20;
  bool anew = false;       // validation always times anew
};
Result<std::vector<TimeSeries>> measureTimes(const Measuring& measuring, const TimingPlan& plan,
                                             const std::vector<SeriesRequest>& requests);

}  // namespace reprise

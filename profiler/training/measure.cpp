#include "profiler/training/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "profiler/metrics/metrics.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr double kRounding = 1e-6;

SeriesKey keyOf(const Measuring& measuring, const std::string& session, const SeriesRequest& request) {
  SeriesKey key = measuring.base;
  key.session = session;
  key.variant_hash = request.variant_hash;
  key.period_frames = request.period_frames;
  return key;
}

// Errors with costly metrics are a series of their own: one without them may be there already, and is never added to.
SeriesKey errorKeyOf(const Measuring& measuring, const std::string& session, const SeriesRequest& request) {
  SeriesKey key = keyOf(measuring, session, request);
  for (const Metric& metric : metrics())
    if (metric.expensive && std::find(measuring.metrics.begin(), measuring.metrics.end(), metric.name) != measuring.metrics.end()) key.variant_hash += "+" + metric.name;
  return key;
}

Job jobFor(const Measuring& measuring, JobKind kind, const std::string& session, const std::vector<SeriesRequest>& requests) {
  Job job;
  job.kind = kind;
  job.scenario_path = measuring.scenario_path;
  job.session = session;
  job.original_dir = measuring.original_dir;
  for (const SeriesRequest& request : requests) job.entries.push_back({request.package_dir, request.period_frames});
  job.metrics = measuring.metrics;
  job.width = measuring.base.width;
  job.height = measuring.base.height;
  job.device = measuring.device;
  return job;
}

// What concerns the variants, so that the run goes on without them; anything else ends it.
bool isRecorded(const Error& error) { return error.kind == ErrorKind::kMeasurement || error.kind == ErrorKind::kRefused; }

// Runs the entries together; if that fails, one by one, so that one bad variant costs nobody else.
Result<std::vector<ErrorSeries>> runErrors(const Measuring& measuring, const std::string& session,
                                           const std::vector<SeriesRequest>& requests, int frames) {
  Job job = jobFor(measuring, JobKind::kErrors, session, requests);
  job.frames = frames;
  Result<JobResult> result = superviseJob(job, measuring.supervisor, measuring.progress);
  std::vector<ErrorSeries> series(requests.size());
  if (result.ok()) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      series[i].rows = std::move(result->errors[i]);
      REPRISE_TRY(measuring.store->appendErrors(errorKeyOf(measuring, session, requests[i]), series[i].rows));
    }
    return series;
  }
  if (!isRecorded(result.error())) return result.error();
  if (requests.size() == 1) {
    series[0].failure = FailureRow{result.error().code, result.error().message};
    REPRISE_TRY(measuring.store->appendFailure(errorKeyOf(measuring, session, requests[0]), *series[0].failure));
    return series;
  }
  for (std::size_t i = 0; i < requests.size(); ++i) {
    REPRISE_ASSIGN(std::vector<ErrorSeries> one, runErrors(measuring, session, {requests[i]}, frames));
    series[i] = std::move(one[0]);
  }
  return series;
}

std::vector<TimeRow> rowsOfRun(const std::vector<TimeRow>& rows, const std::string& run_id) {
  std::vector<TimeRow> found;
  for (const TimeRow& row : rows)
    if (row.run_id == run_id) found.push_back(row);
  return found;
}

// The same requests in the same session have the same run id, which is how a resumed run recognizes what it has.
std::string runIdOf(const TimingPlan& plan, const std::vector<SeriesRequest>& requests) {
  std::string text = plan.session + " " + std::to_string(plan.rounds);
  for (const SeriesRequest& request : requests) text += "\n" + request.variant_hash + " " + std::to_string(request.period_frames);
  if (plan.anew) text += "\n" + std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
  return contentHash(text);
}

Result<bool> loadRun(const Measuring& measuring, const TimingPlan& plan, const std::vector<SeriesRequest>& requests,
                     std::vector<TimeSeries>& series) {
  const std::string run_id = runIdOf(plan, requests);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    REPRISE_ASSIGN(const std::vector<TimeRow> rows, measuring.store->times(keyOf(measuring, plan.session, requests[i])));
    series[i].rows = rowsOfRun(rows, run_id);
    if (series[i].rows.size() < static_cast<std::size_t>(plan.rounds)) return false;
  }
  return true;
}

// Metrics lie in [0, 1] (metrics.h), but for the rounding of their sums. One that is no number comes of pixels that are not finite, be they of
// the frame before.
Result<void> expectPossible(const std::vector<ErrorRow>& rows, const std::filesystem::path& store) {
  const bool all_finite = std::all_of(rows.begin(), rows.end(), [](const ErrorRow& row) { return row.nonfinite == 0; });
  for (const ErrorRow& row : rows)
    for (const auto& [metric, value] : row.errors) {
      if ((value >= 0 && value <= 1 + kRounding) || (std::isnan(value) && !all_finite)) continue;
      return Error{ErrorKind::kMachine, "store.corrupt",
                   "the store " + store.string() + " is damaged: it holds " + metric + " = " + std::to_string(value) + " of frame " + std::to_string(row.frame) +
                       ", which no measurement gives; move it away to measure anew", {}};
    }
  return {};
}

}  // namespace

Result<std::vector<ErrorSeries>> measureErrors(const Measuring& measuring, const std::string& session,
                                               const std::vector<SeriesRequest>& requests, int frames) {
  std::vector<ErrorSeries> series(requests.size());
  std::vector<SeriesRequest> missing;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const SeriesKey key = errorKeyOf(measuring, session, requests[i]);
    REPRISE_ASSIGN(auto rows, measuring.store->errors(key));
    if (rows) {
      REPRISE_TRY(expectPossible(*rows, measuring.store->path()));
      series[i].rows = std::move(*rows);
      continue;
    }
    REPRISE_ASSIGN(series[i].failure, measuring.store->failure(key));
    if (series[i].failure) continue;
    missing.push_back(requests[i]);
    places.push_back(i);
  }
  if (missing.empty()) return series;
  REPRISE_ASSIGN(std::vector<ErrorSeries> measured, runErrors(measuring, session, missing, frames));
  for (std::size_t i = 0; i < missing.size(); ++i) series[places[i]] = std::move(measured[i]);
  return series;
}

Result<std::vector<TimeSeries>> measureTimes(const Measuring& measuring, const TimingPlan& plan,
                                             const std::vector<SeriesRequest>& requests) {
  std::vector<TimeSeries> series(requests.size());
  if (!plan.anew) {
    REPRISE_ASSIGN(const bool complete, loadRun(measuring, plan, requests, series));
    if (complete) return series;
  }
  Job job = jobFor(measuring, JobKind::kTimes, plan.session, requests);
  job.rounds = plan.rounds;
  job.run_id = runIdOf(plan, requests);
  Result<JobResult> result = superviseJob(job, measuring.supervisor, measuring.progress);
  if (!result.ok()) {
    if (!isRecorded(result.error())) return result.error();
    for (TimeSeries& one : series) one = {{}, FailureRow{result.error().code, result.error().message}};
    return series;
  }
  for (std::size_t i = 0; i < requests.size(); ++i) {
    series[i].rows = std::move(result->times[i]);
    REPRISE_TRY(measuring.store->appendTimes(keyOf(measuring, plan.session, requests[i]), series[i].rows));
  }
  return series;
}

}  // namespace reprise

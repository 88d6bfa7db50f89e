#include "bench/regret.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/probe_ranges.h"
#include "cli/describe_run.h"
#include "cli/train.h"
#include "fitting/solve/paired_ratio.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

constexpr std::size_t kCandidates = 4, kPeriods = 4;

// One variant: t_variant / t_choice, and the error of the worst validation session.
struct Row {
  std::string variant;
  double relative_time = 0, error = 0;
};

// The four periods about the choice's, "never" being the longest.
std::vector<std::uint32_t> periodsAbout(std::vector<std::uint32_t> periods, std::uint32_t chosen) {
  const auto length = [](std::uint32_t period) { return period == kNeverRefresh ? ~0u : period; };
  std::erase(periods, 1u);
  std::sort(periods.begin(), periods.end(), [&](std::uint32_t a, std::uint32_t b) { return length(a) < length(b); });
  if (periods.size() <= kPeriods) return periods;
  const auto at = static_cast<std::size_t>(std::find(periods.begin(), periods.end(), chosen) - periods.begin()) % periods.size();
  const std::size_t first = std::min(at < 2 ? 0 : at - 2, periods.size() - kPeriods);
  return {periods.begin() + static_cast<std::ptrdiff_t>(first), periods.begin() + static_cast<std::ptrdiff_t>(first + kPeriods)};
}

class Search {
 public:
  Search(const RegretPlan& plan, const Subject& subject, const Workspace& workspace, const RunResult& result)
      : plan_(plan), subject_(subject), workspace_(workspace), result_(result) {
    base_ = baseOptions(subject, {});
    if (result.choice.kind == ChoiceKind::kVariant) {
      base_.filter = filterOf(result.choice.filter).value_or(base_.filter);
      base_.encoding = encodingOf(result.choice.encoding).value_or(base_.encoding);
      if (result.choice.block_pixels > 0) base_.block_pixels = result.choice.block_pixels;
      base_.pattern = patternKindOf(result.choice.pattern).value_or(base_.pattern);
    }
    base_.strategy = "original";
    for (const SessionSpec& session : subject.scenario.sessions)
      if (session.role == SessionRole::kValidation) sessions_.push_back(session.name);
  }

  Result<std::vector<Row>> rowsOf(std::size_t candidate) {
    const std::filesystem::path file = plan_.directory / "regret" / fmt::format("{}.json", candidate);
    if (std::filesystem::exists(file)) return readRows(file);
    REPRISE_ASSIGN(std::vector<Row> rows, measure(candidate));
    nlohmann::json document = nlohmann::json::array();
    for (const Row& row : rows) document.push_back({{"variant", row.variant}, {"relative_time", row.relative_time}, {"error", row.error}});
    REPRISE_TRY(writeFile(file, document.dump(1) + "\n"));
    return rows;
  }

 private:
  static Result<std::vector<Row>> readRows(const std::filesystem::path& file) {
    REPRISE_ASSIGN(const std::string text, readFile(file));
    const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
    if (!document.is_array()) return Error{ErrorKind::kInput, "regret.rows", "'" + file.string() + "' is not what was written there; remove it", {}};
    std::vector<Row> rows;
    for (const auto& row : document) {
      const auto error = row.value("error", nlohmann::json());
      rows.push_back({row.value("variant", ""), row.value("relative_time", std::nan("")), error.is_number() ? error.get<double>() : std::nan("")});
    }
    return rows;
  }

  Result<JobResult> runHere(Job& job) const {
    job.scenario_path = workspace_.scenarioFile().string();
    job.device = plan_.device;
    SupervisorOptions options;
    options.worker_path = plan_.worker_path;
    return superviseJob(job, options, {});
  }

  Result<StoredVariant> stored(std::size_t candidate, VariantOptions options, const std::string& strategy, bool counting) const {
    options.strategy = strategy;
    options.instrumented = counting;
    return storeVariant(workspace_, subject_.program, subject_.candidates[candidate], options, subject_.limits);
  }

  // The worst session's error of each period; NaN where a session has no settled frame.
  Result<std::vector<double>> errorsOf(std::size_t candidate, const VariantOptions& options, const std::vector<std::uint32_t>& periods) const {
    REPRISE_ASSIGN(const StoredVariant counting, stored(candidate, options, "branch", true));
    REPRISE_ASSIGN(const StoredVariant original, stored(candidate, options, "original", false));
    const ErrorLimits limits = limitsOf(result_);
    std::vector<double> worst(periods.size(), 0);
    for (const std::string& session : sessions_) {
      Job job;
      job.kind = JobKind::kErrors;
      job.session = session;
      job.original_dir = original.dir;
      for (const std::uint32_t period : periods) job.entries.push_back({counting.dir, period});
      job.metrics = limits.metrics();
      REPRISE_ASSIGN(const JobResult measured, runHere(job));
      for (std::size_t i = 0; i < periods.size(); ++i) {
        const auto error = sessionError(limits, {&measured.errors[i]}, periods[i], options.pattern);
        worst[i] = error && !std::isnan(worst[i]) ? std::max(worst[i], *error) : std::nan("");
      }
    }
    return worst;
  }

  Result<std::vector<Row>> measure(std::size_t candidate) {
    VariantOptions options = base_;
    REPRISE_ASSIGN(const ValueRanges ranges, probeRanges(subject_, workspace_, candidate, {sessions_.front(), plan_.device, plan_.worker_path}));
    options.ranges = ranges;
    if (isInteger(subject_.candidates[candidate].scalar)) options.filter = Filter::kNearest;
    const std::vector<std::uint32_t> periods = periodsAbout(subject_.scenario.periods, result_.choice.period_frames);
    REPRISE_ASSIGN(const std::vector<double> errors, errorsOf(candidate, options, periods));

    const bool varies = result_.choice.kind == ChoiceKind::kVariant;
    REPRISE_ASSIGN(const StoredVariant original, stored(candidate, options, "original", false));
    Job job;
    job.kind = JobKind::kTimes;
    job.original_dir = original.dir;
    job.rounds = imagesOf(subject_.scenario, plan_.rounds);
    job.entries = {{varies ? (workspace_.packageDir()).string() : original.dir, varies ? result_.choice.period_frames : 1}};
    std::vector<Row> rows;
    for (const Strategy& strategy : strategies()) {
      if (!strategy.selectable) continue;
      const Result<StoredVariant> variant = stored(candidate, options, strategy.name, false);
      if (!variant.ok()) continue;  // refused: not in the search
      for (std::size_t i = 0; i < periods.size(); ++i) {
        const std::string period = periods[i] == kNeverRefresh ? "never" : std::to_string(periods[i]);
        rows.push_back({fmt::format("{}, {}, {}", subject_.candidates[candidate].name, strategy.name, period), 0, errors[i]});
        job.entries.push_back({variant->dir, periods[i]});
      }
    }
    std::vector<std::vector<double>> clock(job.entries.size());
    for (const std::string& session : sessions_) {
      job.session = session;
      REPRISE_ASSIGN(const JobResult measured, runHere(job));
      for (std::size_t i = 0; i < clock.size(); ++i) appendTimes(measured.times[i], measured.cpu_device, clock[i]);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].relative_time = 1 / pairedRatio(clock[0], clock[i + 1]).ratio;
    return rows;
  }

  void appendTimes(const std::vector<TimeRow>& rows, bool cpu_clock, std::vector<double>& clock) const {
    std::vector<TimedFrame> frames;
    for (const TimeRow& row : rows) frames.push_back({row.frame, cpu_clock ? row.cpu_ms : row.gpu_ms, row.wall_ms});
    for (const TimedFrame& frame : subject_.scenario.stereo ? pairedEyes(frames) : frames) clock.push_back(frame.clock_ms);
  }

  const RegretPlan& plan_;
  const Subject& subject_;
  const Workspace& workspace_;
  const RunResult& result_;
  VariantOptions base_;
  std::vector<std::string> sessions_;
};

}  // namespace

Result<Regret> measureRegret(const RegretPlan& plan) {
  REPRISE_ASSIGN(const std::string text, readFile(plan.directory / "result.json"));
  REPRISE_ASSIGN(const RunResult result, resultFromJson(text));
  REPRISE_ASSIGN(const Subject subject, readSubject(plan.directory / "scenario" / "scenario.toml"));
  REPRISE_ASSIGN(const Workspace workspace, Workspace::open(plan.directory));
  std::filesystem::create_directories(plan.directory / "regret");
  Search search(plan, subject, workspace, result);
  Regret regret;
  regret.best = "the choice";
  regret.best_error = result.choice.measured_error.value_or(0);  // the original has none
  double least = 1;
  for (std::size_t candidate = 0; candidate < std::min(kCandidates, subject.candidates.size()); ++candidate) {
    if (!subject.candidates[candidate].kept()) break;
    REPRISE_ASSIGN(const std::vector<Row> rows, search.rowsOf(candidate));
    for (const Row& row : rows) {
      ++regret.variants;
      if (!(row.error <= result.threshold.value) || !std::isfinite(row.relative_time)) continue;
      ++regret.within_threshold;
      if (row.relative_time >= least) continue;
      least = row.relative_time;
      regret.best = row.variant;
      regret.best_error = row.error;
    }
  }
  regret.value = 1 / least - 1;
  return regret;
}

}  // namespace reprise

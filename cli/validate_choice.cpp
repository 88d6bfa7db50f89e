#include "cli/validate_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/hold_laws.h"
#include "profiler/metrics/metrics.h"

namespace reprise {
namespace {

struct Times {
  std::vector<double> clock, wall;
};

std::vector<TimedFrame> framesOf(const std::vector<TimeRow>& rows, bool cpu_clock) {
  std::vector<TimedFrame> frames;
  for (const TimeRow& row : rows) frames.push_back({row.frame, cpu_clock ? row.cpu_ms : row.gpu_ms, row.wall_ms});
  return frames;
}

// In stereo by pairs of eyes: one is computed, the other is not, and a median of single eyes would tell of one kind only.
void append(Times& times, const std::vector<TimeRow>& rows, const Subject& subject, bool cpu_clock) {
  const std::vector<TimedFrame> frames = framesOf(rows, cpu_clock);
  for (const TimedFrame& frame : subject.scenario.stereo ? pairedEyes(frames) : frames) {
    times.clock.push_back(frame.clock_ms);
    times.wall.push_back(frame.wall_ms);
  }
}

struct Entries {
  std::vector<SeriesRequest> requests;
  int prepass = -1, limit = -1, variant = -1;  // indices; the original is 0
};

Result<Entries> timedEntries(const Subject& subject, const Workspace& workspace, const ValidationPlan& plan) {
  Entries entries;
  const Candidate& candidate = subject.candidates[plan.candidate];
  const auto add = [&](const std::string& strategy, std::uint32_t period) -> Result<int> {
    VariantOptions options = plan.options;
    options.strategy = strategy;
    options.instrumented = false;
    const Result<StoredVariant> variant = storeVariant(workspace, subject.program, candidate, options, subject.limits);
    if (!variant.ok()) return variant.error().kind == ErrorKind::kRefused ? Result<int>(-1) : Result<int>(variant.error());
    entries.requests.push_back({variant->dir, variant->hash, period});
    return static_cast<int>(entries.requests.size()) - 1;
  };
  REPRISE_TRY(add("original", 1));
  REPRISE_ASSIGN(entries.prepass, add("original_prepass", 1));
  REPRISE_ASSIGN(entries.limit, add("tail_only", 1));
  REPRISE_ASSIGN(entries.variant, add(plan.options.strategy, plan.options.period_frames));
  return entries;
}

// Whether the variant shows what the original shows where it must; else it is judged by that.
Result<bool> equalsOriginal(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const ValidationPlan& plan,
                            Progress& progress, ValidationRun& run) {
  const Candidate& candidate = subject.candidates[plan.candidate];
  VariantOptions options = plan.options;
  options.instrumented = false;
  REPRISE_ASSIGN(const StoredVariant measured, storeVariant(workspace, subject.program, candidate, options, subject.limits));
  VariantToHold held{candidate, options, plan.packages};
  held.packages.push_back(measured.dir);
  REPRISE_ASSIGN(const std::vector<LawVerdict> verdicts, holdLaws(subject, workspace, measuring, {held}, progress));
  if (!verdicts[0].conviction) return true;
  run.judgement = {false, verdicts[0].conviction->code, verdicts[0].conviction->message};
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  run.measured_error = run.worst_session_error = run.worst_frame_error = kUnknown;
  run.original_ms = run.original_wall_ms = run.prepass_ms = run.limit_ms = kUnknown;
  return false;
}

// Errors and counts of the very variant, from its counting copy.
Result<bool> measureValidationErrors(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                     const ValidationPlan& plan, ValidationRun& run) {
  VariantOptions options = plan.options;
  options.instrumented = options.aged = true;
  REPRISE_ASSIGN(const StoredVariant counting, storeVariant(workspace, subject.program, subject.candidates[plan.candidate], options, subject.limits));
  for (ValidatedSession& session : run.sessions) {
    REPRISE_ASSIGN(std::vector<ErrorSeries> series,
                   measureErrors(measuring, session.name, {{counting.dir, counting.hash, plan.options.period_frames}}, 0));
    if (series[0].failure) {
      run.judgement = {false, "judge.unmeasured", "the variant could not be played: " + series[0].failure->message};
      return false;
    }
    session.rows = std::move(series[0].rows);
  }
  return true;
}

// Over the sessions, in the unit of the limits. NaN where nothing was measured.
MetricOutcome outcomeOf(const ErrorLimits& limits, const ValidationPlan& plan, const ValidationRun& run) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const auto errorOf = [&](const std::vector<const std::vector<ErrorRow>*>& rows) {
    return sessionError(limits, rows, plan.options.period_frames, plan.options.pattern);
  };
  MetricOutcome outcome;
  std::vector<const std::vector<ErrorRow>*> all;
  for (const ValidatedSession& session : run.sessions) {
    all.push_back(&session.rows);
    outcome.worst_session = std::max(outcome.worst_session, errorOf({&session.rows}).value_or(0));
    for (const ErrorRow& row : session.rows)
      if (countsForError(row.frame, plan.options.period_frames, plan.options.pattern))
        outcome.worst_frame = std::max(outcome.worst_frame, frameError(limits, row).value_or(0));
  }
  outcome.all_sessions = errorOf(all).value_or(kUnknown);
  if (!std::isfinite(outcome.all_sessions)) outcome.worst_session = outcome.worst_frame = kUnknown;
  return outcome;
}

std::vector<JudgedError> judgedErrors(const ErrorLimits& limits, const ValidationRun& run) {
  std::vector<JudgedError> judged;
  for (const Threshold& threshold : limits.thresholds) {
    JudgedError error{threshold.metric, std::numeric_limits<double>::quiet_NaN(), threshold.value};
    for (const MetricOutcome& outcome : run.metrics)
      if (outcome.metric == threshold.metric) error.measured = outcome.worst_session;
    judged.push_back(error);
  }
  return judged;
}

void summarizeErrors(const ValidationPlan& plan, ValidationRun& run) {
  const int settled = firstSettledFrame(plan.options.period_frames);
  double hits = 0, covered = 0, fragments = 0, frames = 0;
  for (const ValidatedSession& session : run.sessions) {
    for (const ErrorRow& row : session.rows) {
      run.spoiled += row.spoiled;
      if (row.frame < settled) continue;
      hits += static_cast<double>(row.hits);
      covered += static_cast<double>(row.covered);
      fragments += static_cast<double>(row.shaded_hits + row.shaded_misses);
      ++frames;
    }
  }
  const MetricOutcome binding = outcomeOf(plan.limits, plan, run);
  run.measured_error = binding.all_sessions;
  run.worst_session_error = binding.worst_session;
  run.worst_frame_error = binding.worst_frame;
  for (const Metric& metric : metrics()) {
    MetricOutcome outcome = outcomeOf({{{metric.name, 1}}}, plan, run);
    if (!std::isfinite(outcome.all_sessions)) continue;
    outcome.metric = metric.name;
    run.metrics.push_back(std::move(outcome));
  }
  run.hit_rate = covered > 0 ? hits / covered : 0;
  run.fragments_per_frame = frames > 0 ? fragments / frames : 0;
}

Result<void> measureValidationTimes(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                    const ValidationPlan& plan, ValidationRun& run) {
  REPRISE_ASSIGN(const Entries entries, timedEntries(subject, workspace, plan));
  std::vector<Times> times(entries.requests.size());
  std::vector<std::vector<TimeSeries>> by_session;
  for (const ValidatedSession& session : run.sessions) {
    REPRISE_ASSIGN(std::vector<TimeSeries> series, measureTimes(measuring, {session.name, imagesOf(subject.scenario, plan.rounds), true}, entries.requests));
    for (std::size_t i = 0; i < series.size(); ++i) append(times[i], series[i].rows, subject, plan.cpu_clock);
    by_session.push_back(std::move(series));
  }
  const auto at = [&](int entry) -> const Times& { return times[static_cast<std::size_t>(entry)]; };
  run.original_ms = medianOf(at(0).clock);
  run.original_wall_ms = medianOf(at(0).wall);
  run.prepass_ms = entries.prepass >= 0 ? medianOf(at(entries.prepass).clock) : std::numeric_limits<double>::quiet_NaN();
  const int reference = run.prepass_ms < run.original_ms ? entries.prepass : 0;
  run.limit_ms = entries.limit >= 0 ? limitFrameTime(subject.scenario, medianOf(at(reference).clock), medianOf(at(entries.limit).clock))
                                    : std::numeric_limits<double>::quiet_NaN();
  run.reference = reference == 0 ? "original" : "original_prepass";
  if (entries.variant < 0 || at(entries.variant).clock.size() != at(reference).clock.size()) return {};
  run.binding = pairedRatio(at(reference).clock, at(entries.variant).clock);
  run.wall = pairedRatio(at(reference).wall, at(entries.variant).wall);
  for (std::size_t i = 0; i < run.sessions.size(); ++i) {
    run.sessions[i].variant = framesOf(by_session[i][static_cast<std::size_t>(entries.variant)].rows, plan.cpu_clock);
    run.sessions[i].reference = framesOf(by_session[i][static_cast<std::size_t>(reference)].rows, plan.cpu_clock);
  }
  return {};
}

Measuring byBindingMetrics(Measuring measuring, const ErrorLimits& limits, Progress& progress) {
  measuring.metrics = limits.metrics();  // and all cheap ones: FLIP takes longer than the frames
  measuring.progress = [&progress](const JobProgress& state) { progress.update(state.done, state.total); };
  return measuring;
}

// The thresholds hold for every session, not only for all of them together.
Result<void> timeAndJudge(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const ValidationPlan& plan,
                          ValidationRun& run) {
  run.binding = run.wall = {};
  REPRISE_TRY(measureValidationTimes(subject, workspace, measuring, plan, run));
  run.judgement = judge({judgedErrors(plan.limits, run), run.spoiled, run.binding, run.wall, plan.cpu_clock ? "process CPU time" : "time stamps"}, plan.least_gain);
  return {};
}

}  // namespace

Result<void> timeAgain(const Subject& subject, const Workspace& workspace, const Measuring& measuring, const ValidationPlan& plan,
                       Progress& progress, ValidationRun& run) {
  progress.begin(fmt::format("validate {} n={}, times", plan.options.strategy, plan.options.period_frames));
  return timeAndJudge(subject, workspace, byBindingMetrics(measuring, plan.limits, progress), plan, run);
}

Result<ValidationRun> validateChoice(const Subject& subject, const Workspace& workspace, const Measuring& measuring_given,
                                     const ValidationPlan& plan, Progress& progress) {
  const Measuring measuring = byBindingMetrics(measuring_given, plan.limits, progress);
  ValidationRun run;
  for (const SessionSpec& session : subject.scenario.sessions)
    if (session.role == SessionRole::kValidation) run.sessions.push_back({session.name, {}, {}, {}});
  REPRISE_ASSIGN(const bool equal, equalsOriginal(subject, workspace, measuring, plan, progress, run));
  if (!equal) return run;
  progress.begin(fmt::format("validate {} n={}", plan.options.strategy, plan.options.period_frames));
  REPRISE_ASSIGN(const bool played, measureValidationErrors(subject, workspace, measuring, plan, run));
  if (!played) return run;
  summarizeErrors(plan, run);
  // What the thresholds rule out need not be timed.
  if (run.judgement = judgeErrors({judgedErrors(plan.limits, run), run.spoiled, {}, {}, ""}); !run.judgement.code.empty()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    run.binding.ratio = run.wall.ratio = run.original_ms = run.original_wall_ms = run.prepass_ms = run.limit_ms = kUnknown;
    return run;
  }
  REPRISE_TRY(timeAndJudge(subject, workspace, measuring, plan, run));
  return run;
}

}  // namespace reprise

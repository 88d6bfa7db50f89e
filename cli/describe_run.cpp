#include "cli/describe_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/strategies/cache_layout.h"
#include "compiler/strategies/pair_passes.h"
#include "fitting/selection/pace.h"
#include "fitting/solve/order_range.h"
#include "fitting/solve/paired_ratio.h"

namespace reprise {
namespace {

std::optional<double> known(double value) { return std::isfinite(value) ? std::optional<double>(value) : std::nullopt; }

// "poor: misses the measured errors by 40%". Some explanations begin with the verdict themselves.
std::string verdictText(FitVerdict verdict, const std::string& explanation) {
  const std::string name = nameOf(verdict);
  return explanation.empty() ? name : explanation.starts_with(name) ? explanation : name + ": " + explanation;
}

RunErrorModel describeModel(const ErrorFit& fit) {
  RunErrorModel model{fit.family, {}, known(fit.r_squared), verdictText(fit.verdict, fit.explanation)};
  for (const FittedParameter& parameter : fit.parameters)
    model.parameters.push_back({parameter.name, parameter.value, RunInterval{parameter.lo, parameter.hi}});
  return model;
}

// Two histories: this frame's and the last one's.
// Two images, which swap their roles, but for pairs.
double cacheBytes(const Candidate& candidate, const VariantOptions& options, const std::string& strategy) {
  const bool one_image = options.previous == PreviousImage::kOtherEye && storesOnceAPair(*findStrategy(strategy));
  return (one_image ? 1.0 : 2.0) * cacheLayout(candidate.channels, options.encoding, isInteger(candidate.scalar)).bytes_per_pixel;
}

std::vector<double> clockTimes(const std::vector<TimedFrame>& frames, bool in_pairs) {
  std::vector<double> times;
  for (const TimedFrame& frame : in_pairs ? pairedEyes(frames) : frames) times.push_back(frame.clock_ms);
  return times;
}

std::vector<double> clockOf(const std::map<std::string, std::vector<TimedFrame>>& sessions, bool in_pairs) {
  std::vector<double> times;
  for (const auto& [session, frames] : sessions)
    for (const TimedFrame& frame : in_pairs ? pairedEyes(frames) : frames) times.push_back(frame.clock_ms);
  return times;
}

std::optional<double> measuredError(const ErrorStudy& study, std::uint32_t period, const ErrorLimits& limits) {
  const auto sessions = study.rows.find(period);
  if (sessions == study.rows.end()) return std::nullopt;
  std::vector<const std::vector<ErrorRow>*> rows;
  for (const auto& [session, series] : sessions->second) rows.push_back(&series);
  return sessionError(limits, rows, period, study.options.pattern);
}

// What the errors of single frames lie in, over all settled frames, but for 2.5% at each end.
std::optional<RunInterval> frameErrors(const ErrorStudy& study, std::uint32_t period, const ErrorLimits& limits) {
  std::vector<double> errors;
  const auto sessions = study.rows.find(period);
  if (sessions == study.rows.end()) return std::nullopt;
  for (const auto& [session, rows] : sessions->second)
    for (const ErrorRow& row : rows)
      if (const auto error = frameError(limits, row); countsForError(row.frame, period, study.options.pattern) && row.covered > 0 && error)
        errors.push_back(*error);
  if (errors.empty()) return std::nullopt;
  const OrderRange range = middleRange(std::move(errors), 0.95);
  return RunInterval{range.lo, range.hi};
}

// Rounds pair within a session, by their place.
void describeTimes(const CostStudy& costs, std::uint32_t period, bool in_pairs, RunPoint& point) {
  const auto timed = costs.frames.find(period);
  if (timed == costs.frames.end()) return;
  const std::vector<double> all = clockOf(timed->second, in_pairs);
  point.measured_frame_ms = known(medianOf(all));
  if (!all.empty()) {
    const OrderRange range = medianInterval(all);
    point.measured_frame_ms_ci95 = RunInterval{range.lo, range.hi};
  }
  std::vector<double> variant, original;
  for (const auto& [session, frames] : timed->second) {
    const auto reference = costs.reference.find(session);
    if (reference == costs.reference.end() || reference->second.size() != frames.size()) continue;
    for (const double ms : clockTimes(frames, in_pairs)) variant.push_back(ms);
    for (const double ms : clockTimes(reference->second, in_pairs)) original.push_back(ms);
  }
  const PairedRatio ratio = pairedRatio(original, variant);
  if (ratio.pairs == 0) return;
  point.measured_speedup = known(ratio.ratio);
  point.speedup_ci95 = RunInterval{ratio.lo, ratio.hi};
}

void addPoints(const Training& training, const FittedTraining& fitted, const Selection& selection, std::size_t configuration,
               const ErrorLimits& limits, RunConfiguration& described) {
  const CostStudy& costs = training.costs[fitted.cost_study[configuration]];
  const ErrorFit& fit = fitted.input.configurations[configuration].error_fit;
  const ErrorStudy& errors = training.errors[costs.error_study];
  for (const TradeoffPoint& point : selection.points) {
    if (point.configuration != configuration) continue;
    RunPoint entry;
    entry.period_frames = point.period_frames;
    entry.predicted_error = known(point.predicted_error);
    entry.predicted_frame_ms = known(point.predicted_frame_ms);
    entry.measured_error = measuredError(errors, point.period_frames, limits);
    entry.predicted_hit_rate = known(point.predicted_hit_rate);
    entry.measured_error_frames = frameErrors(errors, point.period_frames, limits);
    if (point.period_frames != kNeverRefresh && isUsable(fit.verdict)) {
      const ErrorPrediction error = predictError(fit, point.period_frames);
      entry.predicted_error_ci95 = RunInterval{error.lo, error.hi};
    }
    describeTimes(costs, point.period_frames, errors.options.previous == PreviousImage::kOtherEye, entry);
    described.points.push_back(entry);
  }
}

RunConfiguration describeConfiguration(const Configuration& configuration) {
  RunConfiguration described;
  described.strategy = configuration.strategy;
  described.pattern = configuration.pattern;
  described.filter = configuration.filter;
  described.encoding = configuration.encoding;
  described.block_pixels = configuration.block_pixels;
  described.cost_verdict = verdictText(configuration.cost.verdict, configuration.cost.explanation);
  described.cost_r_squared = known(configuration.cost.r_squared);
  if (isUsable(configuration.cost.verdict)) {
    described.hit_ns = configuration.cost.cost.hit_ns;
    described.miss_ns = configuration.cost.cost.miss_ns;
    described.overhead_ms = configuration.cost.cost.overhead_ms;
  }
  return described;
}

// An error study without a strategy's times still has a curve: its points without frame times.
RunConfiguration untimedConfiguration(const ErrorStudy& study, const Subject& subject, const ErrorLimits& limits) {
  RunConfiguration described;
  described.strategy = study.options.strategy;
  described.pattern = nameOf(study.options.pattern);
  described.filter = nameOf(study.options.filter);
  described.encoding = nameOf(study.options.encoding);
  described.block_pixels = blockPixels(study.options);
  described.cost_verdict = "not timed";
  const ErrorFit fit = fitErrors(study, limits);
  for (const std::uint32_t period : subject.scenario.periods) {
    if (period == 1) continue;
    RunPoint point;
    point.period_frames = period;
    if (period != kNeverRefresh && isUsable(fit.verdict)) point.predicted_error = known(predictError(fit, period).value);
    point.measured_error = measuredError(study, period, limits);
    described.points.push_back(point);
  }
  return described;
}

void describeStatus(const Training& training, std::size_t index, const Candidate& candidate, bool has_rows, RunCandidate& described) {
  if (!candidate.kept()) {
    const bool refused = candidate.dropped.code.rfind("shader.", 0) == 0 || candidate.dropped.code.rfind("tail.", 0) == 0;
    described.status = refused ? CandidateStatus::kRefused : CandidateStatus::kPruned;
    described.reason = {candidate.dropped.code, candidate.dropped.message};
  } else if (const auto failed = training.failed.find(index); failed != training.failed.end()) {
    described.status = CandidateStatus::kFailed;
    described.reason = {"train.failed", failed->second};
  } else if (const auto convicted = training.convicted.find(index); convicted != training.convicted.end()) {
    described.status = CandidateStatus::kFailed;
    described.reason = {convicted->second.code, convicted->second.message};
  } else if (has_rows) {
    described.status = CandidateStatus::kTrained;
  } else {
    described.status = CandidateStatus::kNotReached;
    described.reason = {"train.budget", "the budget ended before it was measured"};
    for (const ErrorStudy& study : training.errors)
      if (study.candidate == index && !study.failure.empty()) {
        described.status = CandidateStatus::kFailed;
        described.reason = {"train.failed", study.failure};
      }
  }
}

}  // namespace

std::vector<RunCandidate> describeCandidates(const Subject& subject, const Training& training, const FittedTraining& fitted,
                                             const Selection& selection, const ErrorLimits& limits) {
  std::vector<RunCandidate> described;
  for (std::size_t index = 0; index < subject.candidates.size(); ++index) {
    const Candidate& candidate = subject.candidates[index];
    RunCandidate entry;
    entry.id = candidate.id;
    entry.name = candidate.name;
    entry.type = candidate.type;
    entry.file = candidate.place.file;
    entry.line = candidate.place.line;
    entry.column = candidate.place.column;
    entry.cost = candidate.saved_cost;
    entry.cost_share = candidate.share;
    entry.inputs = inputNames(candidate, subject.program.analysis);
    bool has_rows = false;
    for (std::size_t study = 0; study < training.errors.size(); ++study) {
      const ErrorStudy& errors = training.errors[study];
      if (errors.candidate != index || errors.rows.empty()) continue;
      if (!has_rows) entry.error_model = describeModel(fitErrors(errors, limits));
      has_rows = true;
      bool timed = false;
      for (std::size_t i = 0; i < fitted.cost_study.size(); ++i) {
        if (training.costs[fitted.cost_study[i]].error_study != study) continue;
        timed = true;
        const Configuration& configuration = fitted.input.configurations[i];
        if (!entry.hit_rate_mu && isUsable(configuration.hit_rate.verdict)) entry.hit_rate_mu = configuration.hit_rate.mu.value;
        RunConfiguration one = describeConfiguration(configuration);
        one.cache_bytes_per_pixel = cacheBytes(candidate, errors.options, one.strategy);
        addPoints(training, fitted, selection, i, limits, one);
        entry.configurations.push_back(std::move(one));
      }
      if (!timed) entry.configurations.push_back(untimedConfiguration(errors, subject, limits));
    }
    if (const auto limit = training.limits.find(index); limit != training.limits.end())
      entry.limit_frame_ms = known(limitFrameTime(subject.scenario, fitted.input.original_frame_ms, medianOf(clockTimes(limit->second, false))));
    describeStatus(training, index, candidate, has_rows, entry);
    described.push_back(std::move(entry));
  }
  return described;
}

RunVariant describeVariant(const Configuration& configuration, std::uint32_t period_frames) {
  return {configuration.candidate_id, configuration.strategy, configuration.pattern, configuration.filter, configuration.encoding,
          configuration.block_pixels, period_frames};
}

std::vector<std::string> fitWarnings(const RunResult& result) {
  std::vector<std::string> warnings;
  for (const RunCandidate& candidate : result.candidates) {
    if (result.choice.kind != ChoiceKind::kVariant || candidate.id != result.choice.candidate_id) continue;
    const std::string name = candidate.name.empty() ? candidate.id : candidate.name;
    if (candidate.error_model && !candidate.error_model->verdict.starts_with(nameOf(FitVerdict::kGood)))
      warnings.push_back(fmt::format("{}: model of the error is {}", name, candidate.error_model->verdict));
    for (const RunConfiguration& one : candidate.configurations)
      if (one.strategy == result.choice.strategy && one.pattern == result.choice.pattern && one.filter == result.choice.filter &&
          one.encoding == result.choice.encoding && one.block_pixels == result.choice.block_pixels && !one.cost_verdict.starts_with(nameOf(FitVerdict::kGood)))
        warnings.push_back(fmt::format("{}: model of the cost is {}", name, one.cost_verdict));
  }
  return warnings;
}

RunAttempt describeAttempt(const FittedTraining& fitted, const ValidationAttempt& attempt) {
  const Configuration& configuration = fitted.input.configurations[attempt.configuration];
  RunAttempt described;
  described.candidate_id = configuration.candidate_id;
  const std::string blocks = configuration.block_pixels > 0 ? fmt::format(" {0}x{0}", configuration.block_pixels) : "";
  described.configuration = fmt::format("{}, {}{}, {}, {}", configuration.strategy, configuration.pattern, blocks, configuration.filter,
                                        configuration.encoding);
  described.period_frames = attempt.point.period_frames;
  described.measured_error = known(attempt.run.worst_session_error);
  described.measured_speedup = known(attempt.run.binding.ratio);
  if (attempt.run.binding.pairs > 0) described.speedup_ci95 = RunInterval{attempt.run.binding.lo, attempt.run.binding.hi};
  described.accepted = attempt.run.judgement.accepted;
  described.reason = attempt.run.judgement.reason;
  return described;
}

ErrorLimits limitsOf(const RunResult& result) {
  ErrorLimits limits;
  for (const RunThreshold& threshold : result.thresholds) limits.thresholds.push_back({threshold.metric, threshold.value});
  if (limits.thresholds.empty()) limits.thresholds.push_back({result.threshold.metric, result.threshold.value});
  return limits;
}

std::vector<RunMetric> describeMetrics(const ValidationRun& run) {
  std::vector<RunMetric> described;
  for (const MetricOutcome& outcome : run.metrics) described.push_back({outcome.metric, outcome.all_sessions, outcome.worst_session, outcome.worst_frame});
  return described;
}

std::vector<RunSession> describeSessions(const ValidationRun& run, const ErrorLimits& limits) {
  std::vector<RunSession> sessions;
  for (const ValidatedSession& session : run.sessions) {
    RunSession described{session.name, {}};
    for (const ErrorRow& row : session.rows) {
      RunFrame frame;
      frame.frame = row.frame;
      frame.error = frameError(limits, row).value_or(std::nan(""));
      if (row.covered > 0) frame.hit_rate = static_cast<double>(row.hits) / static_cast<double>(row.covered);
      for (const TimedFrame& timed : session.variant)
        if (timed.frame == row.frame) frame.frame_ms = timed.clock_ms;
      for (const TimedFrame& timed : session.reference)
        if (timed.frame == row.frame) frame.original_ms = timed.clock_ms;
      described.frames.push_back(frame);
    }
    sessions.push_back(std::move(described));
  }
  return sessions;
}

void describeAccepted(const Subject& subject, const Training& training, const FittedTraining& fitted, const ValidationAttempt& attempt,
                      RunResult& result) {
  const Configuration& configuration = fitted.input.configurations[attempt.configuration];
  const ErrorStudy& study = training.errors[training.costs[fitted.cost_study[attempt.configuration]].error_study];
  const Candidate& candidate = subject.candidates[study.candidate];
  const ValidationRun& run = attempt.run;
  RunChoice& choice = result.choice;
  choice.kind = ChoiceKind::kVariant;
  choice.reason = run.judgement.reason;
  choice.candidate_id = candidate.id;
  for (const CandidateValue& value : candidate.values) {
    const std::string unnamed = candidate.values.size() == 1 ? candidate.id : value.operation;
    choice.payload.push_back({value.name.empty() ? unnamed : value.name, value.type, value.place.file, value.place.line, value.place.column});
  }
  choice.strategy = configuration.strategy;
  choice.pattern = configuration.pattern;
  choice.filter = configuration.filter;
  choice.encoding = configuration.encoding;
  choice.block_pixels = configuration.block_pixels;
  choice.period_frames = attempt.point.period_frames;
  choice.predicted_error = known(attempt.point.predicted_error);
  choice.measured_error = known(run.measured_error);
  choice.worst_frame_error = known(run.worst_frame_error);
  choice.predicted_speedup = known(attempt.point.predicted_speedup);
  choice.measured_speedup = known(run.binding.ratio);
  choice.speedup_ci95 = RunInterval{run.binding.lo, run.binding.hi};
  choice.wall_speedup = known(run.wall.ratio);
  choice.wall_speedup_ci95 = RunInterval{run.wall.lo, run.wall.hi};
  // Predicted for the validation's own hits and misses, as its scene covers another share of the screen than training's, and at
  // its pace: what a machine takes for the same work drifts by more between two runs than within one.
  const double hits = run.fragments_per_frame * run.hit_rate;
  choice.pace = known(paceOf({fitted.input.original_frame_ms, configuration.fragments_per_frame},
                              {run.prepass_ms < run.original_ms ? run.prepass_ms : run.original_ms, run.fragments_per_frame}));
  choice.predicted_frame_ms = known(choice.pace.value_or(1) * predictFrameTime(configuration.cost, hits, run.fragments_per_frame - hits));
  choice.measured_frame_ms = known(run.binding.variant_median_ms);
  choice.p95_ms = known(run.binding.variant_p95_ms);
  choice.worst_ms = known(run.binding.variant_worst_ms);
  choice.hit_rate = run.hit_rate;
  choice.cache_bytes_per_pixel = cacheBytes(candidate, study.options, choice.strategy);
  result.limit = {known(run.limit_ms), candidate.id};
}

}  // namespace reprise

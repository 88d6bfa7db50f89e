#include "cli/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/report/text.h"

namespace reprise {
namespace {

std::string nameOf(const RunCandidate& candidate) { return candidate.name.empty() ? candidate.id : candidate.name; }

std::string intervalText(double ratio, const std::optional<RunInterval>& ci) {
  return ci ? fmt::format("{} times as fast (95% interval {} to {})", formatNumber(ratio), formatNumber(ci->lo), formatNumber(ci->hi))
            : fmt::format("{} times as fast", formatNumber(ratio));
}

template <typename Visit>
void visitPoints(const RunResult& run, Visit visit) {
  for (const RunCandidate& candidate : run.candidates)
    for (const RunConfiguration& configuration : candidate.configurations)
      for (const RunPoint& point : configuration.points)
        if (point.period_frames != 1) visit(candidate, configuration, point);
}

// Of what validation timed, else of what training timed within the thresholds.
std::optional<std::string> fastestVariant(const RunResult& run) {
  const RunAttempt* best = nullptr;
  for (const RunAttempt& attempt : run.attempts)
    if (attempt.measured_speedup && (best == nullptr || *attempt.measured_speedup > *best->measured_speedup)) best = &attempt;
  if (best != nullptr)
    return fmt::format("the fastest that was validated, {} ({}, {}), is {}", best->candidate_id, best->configuration, refreshText(best->period_frames),
                       intervalText(*best->measured_speedup, best->speedup_ci95));
  double fastest = 0;
  std::optional<std::string> text;
  visitPoints(run, [&](const RunCandidate& candidate, const RunConfiguration& configuration, const RunPoint& point) {
    const bool keeps = point.measured_error && *point.measured_error <= run.threshold.value;
    if (!keeps || !point.measured_speedup || *point.measured_speedup <= fastest) return;
    fastest = *point.measured_speedup;
    text = fmt::format("the fastest that was measured within the thresholds, '{}' ({}, {}), is {}", nameOf(candidate), configuration.strategy,
                       refreshText(point.period_frames), intervalText(fastest, point.speedup_ci95));
  });
  return text;
}

std::optional<std::string> leastError(const RunResult& run) {
  std::optional<double> least;
  std::string text;
  visitPoints(run, [&](const RunCandidate& candidate, const RunConfiguration&, const RunPoint& point) {
    const std::optional<double> error = point.measured_error ? point.measured_error : point.predicted_error;
    if (!error || (least && *error >= *least)) return;
    least = error;
    text = fmt::format("no trained value keeps {}: the least error is {}, of '{}' {}", thresholdsText(run), errorText(run, *error), nameOf(candidate),
                       refreshText(point.period_frames));
  });
  if (!least || *least <= run.threshold.value) return std::nullopt;
  return text;
}

bool hasKeptCandidates(const RunResult& run) {
  return std::any_of(run.candidates.begin(), run.candidates.end(), [](const RunCandidate& candidate) {
    return candidate.status != CandidateStatus::kPruned && candidate.status != CandidateStatus::kRefused;
  });
}

// Empty where enough was measured.
std::string whatIsMissing(const RunResult& run, const Measured& measured) {
  if (measured.budget_ended) {
    const std::string first = run.not_reached.empty() ? "all that was planned" : run.not_reached.front();
    const std::size_t others = run.not_reached.size() > 1 ? run.not_reached.size() - 1 : 0;
    return "the budget ended before " + first + (others > 0 ? fmt::format(" and {} more", others) : "") +
           "; the same command with a larger --budget goes on from here, and measures nothing twice";
  }
  if (measured.none_validated) return "no variant could be measured in validation: " + run.attempts.back().reason;
  if (measured.more_to_validate)
    return fmt::format("{} variants failed in validation, and others that may do were not tried; the last one: {}", run.attempts.size(), run.attempts.back().reason);
  if (!run.attempts.empty()) return "";
  if (!run.original.frame_ms) return "the original could not be timed; see the warnings";
  if (measured.selection.original_reason_code == "selection.no_model")
    return "the measurements fit no model (" + measured.selection.original_reason + "); longer sessions, or sessions in which more changes, may";
  const bool all_failed = std::all_of(run.candidates.begin(), run.candidates.end(), [](const RunCandidate& one) { return one.status != CandidateStatus::kTrained; });
  return all_failed ? "no candidate could be measured; their reasons stand beside them" : "";
}

}  // namespace

Answer answerWithoutVariant(const RunResult& run, const Measured& measured) {
  if (!hasKeptCandidates(run)) return {ChoiceKind::kOriginal, "no value of the shader is worth caching"};
  if (std::string missing = whatIsMissing(run, measured); !missing.empty()) return {ChoiceKind::kUndecided, std::move(missing)};
  std::string reason = run.attempts.empty() ? leastError(run).value_or(measured.selection.original_reason)
                                            : "no variant kept its promise in validation; the last one: " + run.attempts.back().reason;
  if (const std::optional<std::string> fastest = fastestVariant(run)) reason += "; " + *fastest;
  return {ChoiceKind::kOriginal, reason};
}

}  // namespace reprise

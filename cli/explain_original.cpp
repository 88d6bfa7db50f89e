#include "cli/explain_original.h"

#include <fmt/format.h>

#include <optional>

namespace reprise {
namespace {

struct LeastError {
  double error = 0;
  std::string candidate;
  std::uint32_t period_frames = 1;
};

std::optional<LeastError> leastError(const RunResult& run) {
  std::optional<LeastError> least;
  for (const RunCandidate& candidate : run.candidates)
    for (const RunConfiguration& configuration : candidate.configurations)
      for (const RunPoint& point : configuration.points) {
        const std::optional<double> error = point.measured_error ? point.measured_error : point.predicted_error;
        if (error && (!least || *error < least->error))
          least = LeastError{*error, candidate.name.empty() ? candidate.id : candidate.name, point.period_frames};
      }
  return least;
}

}  // namespace

std::string explainOriginal(const RunResult& run, const Selection& selection) {
  if (!run.attempts.empty()) return "no variant kept its promise in validation; the last one: " + run.attempts.back().reason;
  if (!selection.points.empty() || !selection.dropped.empty()) return selection.original_reason;
  const std::optional<LeastError> least = leastError(run);
  if (least && least->error > run.threshold.value) {
    const std::string period = least->period_frames == 0 ? "never refreshed" : fmt::format("refreshed every {} frames", least->period_frames);
    const std::string others = run.not_reached.empty() ? "" : "; the budget did not reach all candidates";
    return fmt::format("no trained value keeps the {} error at {}: the least is {:.3g}, of '{}' {}{}", run.threshold.metric, run.threshold.value, least->error,
                       least->candidate, period, others);
  }
  if (!run.not_reached.empty()) return "the budget ended before any variant was measured whole; a larger --budget may find one";
  return "no value of the shader is worth caching under the threshold";
}

}  // namespace reprise

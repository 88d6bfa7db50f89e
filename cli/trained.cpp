#include "cli/trained.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiler/metrics/metrics.h"

namespace reprise {

int imagesOf(const Scenario& scenario, int moments) { return scenario.stereo ? 2 * moments : moments; }

double limitFrameTime(const Scenario& scenario, double original_ms, double tail_ms) {
  return scenario.stereo ? (original_ms + tail_ms) / 2 : tail_ms;
}

int firstSettledFrame(std::uint32_t period_frames) {
  return period_frames == kNeverRefresh ? 2 : static_cast<int>(2 * period_frames);
}

std::optional<double> sessionError(const std::string& metric, const std::vector<const std::vector<ErrorRow>*>& sessions,
                                   std::uint32_t period_frames, PatternKind pattern) {
  const Metric* definition = findMetric(metric);
  REPRISE_CHECK(definition != nullptr, metric);
  std::vector<MetricFrame> frames;
  for (const std::vector<ErrorRow>* rows : sessions)
    for (const ErrorRow& row : *rows) {
      const auto value = row.errors.find(metric);
      if (!countsForError(row.frame, period_frames, pattern) || row.covered == 0 || value == row.errors.end() || !std::isfinite(value->second)) continue;
      const auto tiles = row.tiles.find(metric);
      frames.push_back({value->second, static_cast<double>(row.covered), tiles == row.tiles.end() ? nullptr : &tiles->second});
    }
  if (frames.empty()) return std::nullopt;
  return combineFrames(*definition, frames);
}

std::optional<double> sessionError(const ErrorLimits& limits, const std::vector<const std::vector<ErrorRow>*>& sessions,
                                   std::uint32_t period_frames, PatternKind pattern) {
  return limits.error([&](const std::string& metric) { return sessionError(metric, sessions, period_frames, pattern); });
}

std::optional<double> frameError(const ErrorLimits& limits, const ErrorRow& row) {
  const std::optional<double> error = limits.error([&](const std::string& metric) {
    const auto value = row.errors.find(metric);
    return value == row.errors.end() ? std::nullopt : std::optional(value->second);
  });
  return error && std::isfinite(*error) ? error : std::nullopt;
}

bool countsForError(int frame, std::uint32_t period_frames, PatternKind pattern) {
  return frame >= firstSettledFrame(period_frames) && !isWhollyDue({pattern, period_frames, 2}, static_cast<std::uint32_t>(frame));
}

std::vector<TimedFrame> pairedEyes(const std::vector<TimedFrame>& frames) {
  std::vector<TimedFrame> pairs;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const TimedFrame& left = frames[i - 1];
    const TimedFrame& right = frames[i];
    if (right.frame % 2 == 0 || left.frame + 1 != right.frame) continue;
    pairs.push_back({right.frame, (left.clock_ms + right.clock_ms) / 2, (left.wall_ms + right.wall_ms) / 2});
  }
  return pairs;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace reprise

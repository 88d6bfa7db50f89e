#include "fitting/selection/select.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace reprise {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string periodText(std::uint32_t period_frames) {
  return period_frames == 0 ? "never refreshed" : "period " + std::to_string(period_frames);
}

Error inputError(const char* code, std::string message) {
  return {ErrorKind::kInput, code, std::move(message), {}};
}

Result<void> checkInput(const SelectionInput& input, const SelectionOptions& options) {
  if (!(options.threshold >= 0) || !std::isfinite(options.threshold)) {
    return inputError("selection.threshold", "the largest allowed error is " + number(options.threshold) +
                                                 "; give a number that is not negative");
  }
  if (!(options.error_margin >= 0 && options.error_margin < 1)) {
    return inputError("selection.margin", "the error margin is " + number(options.error_margin) +
                                              "; give a share of the threshold in [0, 1)");
  }
  if (!(input.original_frame_ms > 0) || !std::isfinite(input.original_frame_ms)) {
    return inputError("selection.original", "the original's frame time is " + number(input.original_frame_ms) +
                                                " ms; measure it before selecting");
  }
  return {};
}

// "Never" sorts last, as the longest period.
std::uint64_t periodOrder(std::uint32_t period_frames) {
  return period_frames == 0 ? std::uint64_t{1} << 32 : period_frames;
}

std::optional<ErrorPrediction> errorAt(const Configuration& configuration, const AllowedPeriod& allowed) {
  if (allowed.measured_error && std::isfinite(*allowed.measured_error)) {
    return ErrorPrediction{*allowed.measured_error, *allowed.measured_error, *allowed.measured_error};
  }
  if (allowed.period_frames == 0 || !isUsable(configuration.error_fit.verdict)) return std::nullopt;
  return predictError(configuration.error_fit, allowed.period_frames);
}

std::optional<TradeoffPoint> predictPoint(const SelectionInput& input, std::size_t index,
                                          const AllowedPeriod& allowed) {
  const Configuration& configuration = input.configurations[index];
  const std::optional<ErrorPrediction> error = errorAt(configuration, allowed);
  if (!error || !isUsable(configuration.cost.verdict)) return std::nullopt;
  // Period 1 never hits, whatever μ is.
  if (!isUsable(configuration.hit_rate.verdict) && allowed.period_frames != 1) return std::nullopt;
  TradeoffPoint point;
  point.configuration = index;
  point.period_frames = allowed.period_frames;
  point.predicted_error = error->value;
  point.predicted_error_hi = error->hi;
  point.error_measured = allowed.measured_error.has_value() && std::isfinite(*allowed.measured_error);
  point.predicted_hit_rate = hitRate(configuration.hit_rate.mu.value, allowed.period_frames);
  const double hits = configuration.fragments_per_frame * point.predicted_hit_rate;
  point.predicted_frame_ms = predictFrameTime(configuration.cost, hits, configuration.fragments_per_frame - hits);
  if (!(point.predicted_frame_ms > 0) || !std::isfinite(point.predicted_frame_ms)) return std::nullopt;
  if (!std::isfinite(point.predicted_error)) return std::nullopt;
  point.predicted_speedup = input.original_frame_ms / point.predicted_frame_ms;
  return point;
}

std::vector<TradeoffPoint> predictConfiguration(const SelectionInput& input, std::size_t index) {
  std::vector<TradeoffPoint> points;
  for (const AllowedPeriod& allowed : input.configurations[index].periods) {
    if (const std::optional<TradeoffPoint> point = predictPoint(input, index, allowed)) points.push_back(*point);
  }
  std::stable_sort(points.begin(), points.end(), [](const TradeoffPoint& a, const TradeoffPoint& b) {
    return periodOrder(a.period_frames) < periodOrder(b.period_frames);
  });
  return points;
}

bool isFaster(const TradeoffPoint& a, const TradeoffPoint& b) {
  return std::tuple(a.predicted_frame_ms, a.predicted_error, a.configuration, periodOrder(a.period_frames)) <
         std::tuple(b.predicted_frame_ms, b.predicted_error, b.configuration, periodOrder(b.period_frames));
}

const TradeoffPoint& leastErrorOf(const std::vector<TradeoffPoint>& points) {
  return *std::min_element(points.begin(), points.end(), [](const TradeoffPoint& a, const TradeoffPoint& b) {
    return a.predicted_error < b.predicted_error;
  });
}

// Puts the configuration's acceptable points into the ranking, or says why it has none.
void rankConfiguration(const SelectionInput& input, const SelectionOptions& options, std::size_t index,
                       const std::vector<TradeoffPoint>& points, Selection* selection) {
  const auto drop = [&](const char* code, std::string message) {
    selection->dropped.push_back({index, code, std::move(message)});
  };
  if (points.empty()) {
    const Configuration& configuration = input.configurations[index];
    return drop("selection.no_model",
                std::string("no usable models: error ") + nameOf(configuration.error_fit.verdict) + ", hit rate " +
                    nameOf(configuration.hit_rate.verdict) + ", cost " + nameOf(configuration.cost.verdict));
  }
  const double limit = options.threshold * (1 - options.error_margin);
  std::vector<TradeoffPoint> acceptable;
  std::copy_if(points.begin(), points.end(), std::back_inserter(acceptable),
               [&](const TradeoffPoint& point) { return point.predicted_error <= limit; });
  if (acceptable.empty()) {
    const TradeoffPoint& least = leastErrorOf(points);
    return drop("selection.error", "the least predicted error is " + number(least.predicted_error) + " (" +
                                       periodText(least.period_frames) + "), above " + number(limit) +
                                       ", the threshold less its margin");
  }
  std::sort(acceptable.begin(), acceptable.end(), isFaster);
  const double fastest_speedup = acceptable.front().predicted_speedup;
  if (!(fastest_speedup > options.least_speedup)) {
    return drop("selection.slow", "predicted at " + number(acceptable.front().predicted_frame_ms) + " ms (" +
                                      periodText(acceptable.front().period_frames) + ") against " +
                                      number(input.original_frame_ms) + " ms of the original");
  }
  for (const TradeoffPoint& point : acceptable) {
    if (!(point.predicted_speedup > options.least_speedup)) break;
    selection->ranking.push_back(point);
    if (!options.shorter_periods) break;
  }
}

std::vector<TradeoffPoint> paretoFront(std::vector<TradeoffPoint> points) {
  std::sort(points.begin(), points.end(), [](const TradeoffPoint& a, const TradeoffPoint& b) {
    return a.predicted_error != b.predicted_error ? a.predicted_error < b.predicted_error : isFaster(a, b);
  });
  std::vector<TradeoffPoint> front;
  for (const TradeoffPoint& point : points) {
    if (front.empty() || point.predicted_frame_ms < front.back().predicted_frame_ms) front.push_back(point);
  }
  return front;
}

// The configuration that came nearest decides the reason: too slow within the threshold, else too erroneous, else
// without models.
void explainOriginal(const SelectionInput& input, const SelectionOptions& options, Selection* selection) {
  if (!selection->ranking.empty()) return;
  if (input.configurations.empty()) {
    selection->original_reason_code = "selection.no_candidates";
    selection->original_reason = "no variant was measured";
    return;
  }
  const auto count = [&](const char* code) {
    return std::count_if(selection->dropped.begin(), selection->dropped.end(),
                         [&](const DroppedConfiguration& dropped) { return dropped.code == code; });
  };
  for (const char* code : {"selection.slow", "selection.error", "selection.no_model"}) {
    if (count(code) == 0) continue;
    selection->original_reason_code = code;
    break;
  }
  selection->original_reason =
      "none of " + std::to_string(input.configurations.size()) + " configurations is predicted faster than the original's " +
      number(input.original_frame_ms) + " ms with an error of at most " + number(options.threshold) + " less a margin of " +
      number(100 * options.error_margin) + "%: " + std::to_string(count("selection.slow")) + " are too slow, " +
      std::to_string(count("selection.error")) + " have too large an error at every period, " +
      std::to_string(count("selection.no_model")) + " have no usable models";
}

}  // namespace

Result<Selection> select(const SelectionInput& input, const SelectionOptions& options) {
  REPRISE_TRY(checkInput(input, options));
  Selection selection;
  for (std::size_t index = 0; index < input.configurations.size(); ++index) {
    const std::vector<TradeoffPoint> points = predictConfiguration(input, index);
    selection.points.insert(selection.points.end(), points.begin(), points.end());
    rankConfiguration(input, options, index, points, &selection);
  }
  std::sort(selection.ranking.begin(), selection.ranking.end(), isFaster);
  selection.pareto = paretoFront(selection.points);
  explainOriginal(input, options, &selection);
  return selection;
}

}  // namespace reprise

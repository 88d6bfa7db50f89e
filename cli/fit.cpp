#include "cli/fit.h"

#include <algorithm>
#include <cmath>

#include "cli/studied_periods.h"
#include "fitting/solve/cost_design.h"

namespace reprise {
namespace {

std::vector<const std::vector<ErrorRow>*> rowsOf(const std::map<std::string, std::vector<ErrorRow>>& sessions) {
  std::vector<const std::vector<ErrorRow>*> rows;
  for (const auto& [session, series] : sessions) rows.push_back(&series);
  return rows;
}

HitRateFit fitHits(const ErrorStudy& study) {
  std::vector<HitRatePoint> points;
  for (const auto& [period, sessions] : study.rows) {
    HitRatePoint point{period, 0, 0};
    for (const auto& [session, rows] : sessions)
      for (const ErrorRow& row : rows) {
        if (row.frame < firstSettledFrame(period)) continue;
        point.hits += static_cast<double>(row.hits);
        point.covered += static_cast<double>(row.covered);
      }
    points.push_back(point);
  }
  return fitHitRate(points);
}

std::vector<CostPoint> costPoints(const ErrorStudy& errors, const CostStudy& costs) {
  std::vector<CostPoint> points;
  for (const TimedCount& frame : timedAndCounted(errors, costs)) points.push_back(frame.point);
  return points;
}

double meanFragments(const ErrorStudy& study) {
  double fragments = 0, frames = 0;
  for (const auto& [period, sessions] : study.rows)
    for (const auto& [session, rows] : sessions)
      for (const ErrorRow& row : rows) fragments += static_cast<double>(row.shaded_hits + row.shaded_misses), ++frames;
  return frames > 0 ? fragments / frames : 0;
}

std::vector<double> clockTimes(const std::vector<TimedFrame>& frames) {
  std::vector<double> times;
  for (const TimedFrame& frame : frames) times.push_back(frame.clock_ms);
  return times;
}

}  // namespace

std::vector<TimedCount> timedAndCounted(const ErrorStudy& errors, const CostStudy& costs) {
  std::vector<TimedCount> points;
  for (const auto& [period, sessions] : costs.frames)
    for (const auto& [session, frames] : sessions) {
      const auto counted = errors.rows.find(period);
      if (counted == errors.rows.end()) continue;
      const auto rows = counted->second.find(session);
      if (rows == counted->second.end()) continue;
      for (const TimedFrame& timed : frames)
        for (const ErrorRow& row : rows->second)
          if (row.frame == timed.frame)
            points.push_back({period, {static_cast<double>(row.shaded_hits), static_cast<double>(row.shaded_misses), timed.clock_ms}});
    }
  return points;
}
std::uint32_t blockPixels(const VariantOptions& options) { return options.pattern == PatternKind::kWhole ? 0 : options.block_pixels; }

std::vector<ErrorPoint> errorPoints(const ErrorStudy& study, const ErrorLimits& limits) {
  std::vector<ErrorPoint> points;
  for (const auto& [period, sessions] : study.rows)
    if (const auto value = sessionError(limits, rowsOf(sessions), period, study.options.pattern); value && period != kNeverRefresh && period > 1)
      points.push_back({period, *value, 0});
  return points;
}

ErrorFit fitErrors(const ErrorStudy& study, const ErrorLimits& limits) { return fitErrorModel(errorPoints(study, limits)); }

std::optional<double> neverError(const ErrorStudy& study, const ErrorLimits& limits) {
  const auto never = study.rows.find(kNeverRefresh);
  return never == study.rows.end() ? std::nullopt : sessionError(limits, rowsOf(never->second), kNeverRefresh);
}

FittedTraining fitTraining(const Subject& subject, const Training& training, const ErrorLimits& limits) {
  FittedTraining fitted;
  fitted.input.original_frame_ms = originalFrameMs(training);
  for (std::size_t i = 0; i < training.costs.size(); ++i) {
    const CostStudy& costs = training.costs[i];
    const ErrorStudy& errors = training.errors[costs.error_study];
    if (costs.frames.empty()) continue;
    Configuration configuration;
    configuration.candidate_id = subject.candidates[errors.candidate].id;
    configuration.strategy = costs.strategy;
    configuration.pattern = nameOf(errors.options.pattern);
    configuration.filter = nameOf(errors.options.filter);
    configuration.encoding = nameOf(errors.options.encoding);
    configuration.block_pixels = blockPixels(errors.options);
    configuration.error_fit = fitErrors(errors, limits);
    configuration.hit_rate = fitHits(errors);
    configuration.cost = fitCost(costPoints(errors, costs));
    configuration.fragments_per_frame = meanFragments(errors);
    for (const std::uint32_t period : selectablePeriods(subject.scenario)) {
      if (period == kNeverRefresh) {
        if (const auto never = neverError(errors, limits)) configuration.periods.push_back({period, never});
      } else {
        configuration.periods.push_back({period, std::nullopt});
      }
    }
    fitted.input.configurations.push_back(std::move(configuration));
    fitted.cost_study.push_back(i);
  }
  return fitted;
}

std::vector<std::string> costWarnings(const Training& training) {
  std::size_t studies = 0, doubtful = 0;
  CostDesign worst;
  for (const CostStudy& costs : training.costs) {
    if (costs.frames.empty()) continue;
    const CostDesign design = judgeCostDesign(costPoints(training.errors[costs.error_study], costs));
    ++studies;
    if (design.frames == 0 || design.isIdentifiable()) continue;
    if (doubtful == 0 || design.singular_value < worst.singular_value) worst = design;
    ++doubtful;
  }
  if (doubtful == 0) return {};
  return {"the cost model is not identifiable for " + std::to_string(doubtful) + " of " + std::to_string(studies) + " timed variants: " + explainCostDesign(worst)};
}

double originalFrameMs(const Training& training) {
  const double plain = medianOf(clockTimes(training.original)), prepass = medianOf(clockTimes(training.prepass));
  return std::isfinite(prepass) ? std::min(plain, prepass) : plain;
}

}  // namespace reprise

#include "fitting/solve/fit_hit_rate.h"

#include <algorithm>
#include <cmath>

#include "fitting/solve/student_t.h"

namespace reprise {

namespace {

struct RateRow {
  double share_not_due = 0, rate = 0, weight = 0;
};

std::vector<RateRow> usableRows(std::span<const HitRatePoint> points) {
  std::vector<RateRow> rows;
  for (const HitRatePoint& point : points) {
    const bool usable = point.period_frames != 1 && std::isfinite(point.hits) && std::isfinite(point.covered) &&
                        point.hits >= 0 && point.covered > 0;
    if (usable) rows.push_back({shareNotDue(point.period_frames), point.hits / point.covered, point.covered});
  }
  return rows;
}

}  // namespace

HitRateFit fitHitRate(std::span<const HitRatePoint> points) {
  HitRateFit fit;
  const std::vector<RateRow> rows = usableRows(points);
  if (rows.empty()) {
    fit.explanation = "no covered pixels at a period of 2 or more";
    return fit;
  }
  double xy = 0, xx = 0, weight = 0, mean = 0;
  for (const RateRow& row : rows) {
    xy += row.weight * row.share_not_due * row.rate;
    xx += row.weight * row.share_not_due * row.share_not_due;
    weight += row.weight;
    mean += row.weight * row.rate;
  }
  mean /= weight;
  fit.mu.value = std::clamp(xy / xx, 0.0, 1.0);
  double unexplained = 0, total = 0;
  for (const RateRow& row : rows) {
    fit.residuals.push_back(row.rate - fit.mu.value * row.share_not_due);
    unexplained += row.weight * fit.residuals.back() * fit.residuals.back();
    total += row.weight * (row.rate - mean) * (row.rate - mean);
  }
  fit.r_squared = unexplained <= 1e-18 * weight ? 1 : total > 0 ? 1 - unexplained / total : 0;
  if (rows.size() == 1) {
    fit.verdict = FitVerdict::kFewPoints;
    fit.explanation = "one measured period: the model meets it and nothing vouches for it";
    return fit;
  }
  const int freedom = static_cast<int>(rows.size()) - 1;
  const double half = studentT975(freedom) * std::sqrt(unexplained / freedom / xx);
  fit.mu.lo = std::max(0.0, fit.mu.value - half);
  fit.mu.hi = std::min(1.0, fit.mu.value + half);
  const double misfit = std::sqrt(unexplained / weight);
  fit.verdict = misfit > 0.1 ? FitVerdict::kPoor : FitVerdict::kGood;
  fit.explanation = "misses the measured hit rates by " + std::to_string(std::lround(1000 * misfit) / 10.0).substr(0, 4) +
                    " percentage points";
  return fit;
}

}  // namespace reprise

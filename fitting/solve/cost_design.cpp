#include "fitting/solve/cost_design.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "fitting/solve/robust_linear.h"

namespace reprise {
namespace {

constexpr double kExpectedScatter = 0.1;
constexpr double kMostUncertainty = 0.5;
constexpr double kLeastSingularValue = 0.01;

struct Spread {
  double least = 0, most = 0, mean = 0, deviation = 0;
};

Spread spreadOf(const std::vector<double>& values) {
  Spread spread;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  spread.least = *least;
  spread.most = *most;
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean) / static_cast<double>(values.size());
  spread.deviation = std::sqrt(squares);
  return spread;
}

}  // namespace

CostDesign judgeCostDesign(std::span<const CostPoint> points) {
  CostDesign design;
  std::vector<double> fragments, shares;
  for (const CostPoint& point : points) {
    const double covered = point.hits + point.misses;
    if (!std::isfinite(covered) || covered <= 0) continue;
    fragments.push_back(covered);
    shares.push_back(point.misses / covered);
  }
  design.frames = fragments.size();
  if (fragments.empty()) return design;
  const Spread coverage = spreadOf(fragments), misses = spreadOf(shares);
  std::vector<LinearRow> rows;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const double part = fragments[i] / coverage.mean;
    rows.push_back({{part * (1 - shares[i]), part * shares[i], 1}, 1});
  }
  design.least_coverage = coverage.least;
  design.most_coverage = coverage.most;
  design.coverage_deviation = coverage.deviation / coverage.mean;
  design.least_miss_share = misses.least;
  design.most_miss_share = misses.most;
  design.miss_share_deviation = misses.deviation;
  design.singular_value = leastSingularValue(rows, 3);
  design.needed_singular_value = std::max(kLeastSingularValue, kExpectedScatter / (kMostUncertainty * std::sqrt(static_cast<double>(rows.size()))));
  return design;
}

std::string explainCostDesign(const CostDesign& design) {
  if (design.frames == 0 || design.isIdentifiable()) return "";
  char figures[160];
  std::snprintf(figures, sizeof figures, " (least singular value %.4f over %zu frames, expected at least %.4f)", design.singular_value, design.frames,
                design.needed_singular_value);
  char text[320];
  // The least singular value is at most about either deviation.
  const bool coverage = design.coverage_deviation < design.needed_singular_value, misses = design.miss_share_deviation < design.needed_singular_value;
  if (coverage || !misses) {
    std::snprintf(text, sizeof text,
                  "%s over the timed training frames (%.0f to %.0f fragments, %.2f times), so a frame's own cost cannot be told from that of its pixels",
                  coverage ? "covered pixels hardly vary" : "covered pixels and the share of misses do not vary enough apart from each other",
                  design.least_coverage, design.most_coverage, design.most_coverage / design.least_coverage);
    return text + std::string(figures) + "; add a training session whose camera comes nearer or goes farther away";
  }
  std::snprintf(text, sizeof text, "the share of misses hardly varies over the timed training frames (%.1f%% to %.1f%%), so hits cannot be told from misses",
                100 * design.least_miss_share, 100 * design.most_miss_share);
  return text + std::string(figures) + "; add refresh periods, or a training session that moves faster";
}

}  // namespace reprise

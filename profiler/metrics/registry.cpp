#include <array>
#include <cmath>
#include <limits>

#include "profiler/metrics/flicker.h"
#include "profiler/metrics/flip.h"
#include "profiler/metrics/mean_difference.h"
#include "profiler/metrics/metrics.h"
#include "profiler/metrics/over8.h"
#include "profiler/metrics/p95.h"
#include "profiler/metrics/rms.h"
#include "profiler/metrics/ssim.h"
#include "runtime/base/check.h"

namespace reprise {

std::span<const Metric> metrics() {
  static const std::array<Metric, 7> table = {rmsMetric(),  meanDifferenceMetric(), p95Metric(),    ssimMetric(),
                                              flipMetric(), over8Metric(),          flickerMetric()};
  return table;
}

const Metric* findMetric(const std::string& name) {
  for (const Metric& metric : metrics()) {
    if (metric.name == name) return &metric;
  }
  return nullptr;
}

double combineFrames(const Metric& metric, std::span<const double> per_frame, std::span<const double> covered) {
  REPRISE_CHECK(per_frame.size() == covered.size(), per_frame.size(), covered.size());
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < per_frame.size(); ++i) {
    if (!(covered[i] > 0)) continue;
    const double weight = metric.combination == SessionCombination::kFrameMean ? 1 : covered[i];
    const double value = per_frame[i];
    sum += weight * (metric.combination == SessionCombination::kRootMeanSquare ? value * value : value);
    weights += weight;
  }
  if (weights == 0) return std::numeric_limits<double>::quiet_NaN();
  return metric.combination == SessionCombination::kRootMeanSquare ? std::sqrt(sum / weights) : sum / weights;
}

}  // namespace reprise

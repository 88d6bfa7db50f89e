#include <array>
#include <cmath>
#include <limits>

#include "profiler/metrics/blocks.h"
#include "profiler/metrics/flicker.h"
#include "profiler/metrics/flip.h"
#include "profiler/metrics/largest.h"
#include "profiler/metrics/mean_difference.h"
#include "profiler/metrics/metrics.h"
#include "profiler/metrics/over8.h"
#include "profiler/metrics/p95.h"
#include "profiler/metrics/relative_rms.h"
#include "profiler/metrics/rms.h"
#include "profiler/metrics/ssim.h"
#include "profiler/metrics/tile_difference.h"
#include "profiler/metrics/tiles.h"
#include "runtime/base/check.h"

namespace reprise {

std::span<const Metric> metrics() {
  static const std::array table = {rmsMetric(),     meanDifferenceMetric(), p95Metric(),      largestMetric(),   relativeRmsMetric(),
                                               ssimMetric(),    flipMetric(),           over8Metric(),    flickerMetric(),   tileRmsMetric(),
                                               tileFlipMetric(), tileFlickerMetric(),   blocksMetric()};
  return table;
}

double Metric::value(const MetricInputs& inputs) const { return tiles ? tailOf(tiles(inputs)) : evaluate(inputs); }

std::string metricNames() {
  std::string names;
  for (const Metric& metric : metrics()) names += (names.empty() ? "" : ", ") + metric.name;
  return names;
}

const Metric* findMetric(const std::string& name) {
  for (const Metric& metric : metrics()) {
    if (metric.name == name) return &metric;
  }
  return nullptr;
}

namespace {

double tailOfFrames(std::span<const MetricFrame> frames) {
  std::vector<float> values;
  for (const MetricFrame& frame : frames)
    if (frame.tiles != nullptr)
      for (const std::uint16_t tile : *frame.tiles) values.push_back(static_cast<float>(tile) / 65535);
  return tailOf(std::move(values));
}

}  // namespace

double combineFrames(const Metric& metric, std::span<const MetricFrame> frames) {
  double sum = 0, weights = 0, worst = 0;
  for (const MetricFrame& frame : frames) {
    if (!(frame.covered > 0)) continue;
    const double weight = metric.combination == SessionCombination::kFrameMean ? 1 : frame.covered;
    sum += weight * (metric.combination == SessionCombination::kRootMeanSquare ? frame.value * frame.value : frame.value);
    weights += weight;
    if (!(frame.value <= worst)) worst = frame.value;
  }
  if (weights > 0 && metric.combination == SessionCombination::kWorst) return worst;
  if (weights > 0 && metric.combination == SessionCombination::kTail) return tailOfFrames(frames);
  if (weights == 0) return std::numeric_limits<double>::quiet_NaN();
  return metric.combination == SessionCombination::kRootMeanSquare ? std::sqrt(sum / weights) : sum / weights;
}

}  // namespace reprise

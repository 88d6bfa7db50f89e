#include "profiler/metrics/mean_difference.h"

#include <cmath>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  double sum = 0;
  const std::size_t covered = visitCovered(*inputs.mask, [&](std::size_t pixel) {
    const std::size_t i = 3 * pixel;
    sum += std::abs(cached[i] - original[i]) + std::abs(cached[i + 1] - original[i + 1]) +
           std::abs(cached[i + 2] - original[i + 2]);
  });
  return covered ? sum / (3.0 * static_cast<double>(covered)) : 0;
}

}  // namespace

Metric meanDifferenceMetric() {
  return {.name = "mean",
          .description = "mean absolute difference over covered pixels and channels",
          .combination = SessionCombination::kMean,
          .evaluate = evaluate};
}

}  // namespace reprise

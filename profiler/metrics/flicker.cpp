#include "profiler/metrics/flicker.h"

#include <cmath>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (!inputs.last_original || !inputs.last_cached) return 0;
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  const float* last_original = inputs.last_original->rgb.data();
  const float* last_cached = inputs.last_cached->rgb.data();
  double sum = 0;
  const std::size_t covered = visitCovered(*inputs.mask, [&](std::size_t pixel) {
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double change = (cached[i] - original[i]) - (last_cached[i] - last_original[i]);
      sum += change * change;
    }
  });
  if (covered == 0) return 0;
  const double rms = std::sqrt(sum / (3.0 * static_cast<double>(covered)));
  return rms > 1 ? 1 : rms;  // NaN stays NaN
}

}  // namespace

Metric flickerMetric() {
  return {.name = "flicker",
          .description = "root of the mean squared frame-to-frame change of the difference over covered pixels and channels",
          .combination = SessionCombination::kMean,
          .evaluate = evaluate};
}

}  // namespace reprise

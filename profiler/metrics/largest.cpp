#include "profiler/metrics/largest.h"

#include <cmath>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {
namespace {

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  float largest = 0;
  visitCovered(*inputs.mask, [&](std::size_t pixel) {
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const float difference = std::abs(cached[i] - original[i]);
      if (std::isnan(largest) || difference <= largest) continue;
      largest = difference;  // a NaN, too
    }
  });
  return largest;
}

}  // namespace

Metric largestMetric() {
  return {.name = "largest",
          .description = "largest difference of a channel over covered pixels, in the worst frame",
          .combination = SessionCombination::kWorst,
          .evaluate = evaluate};
}

}  // namespace reprise

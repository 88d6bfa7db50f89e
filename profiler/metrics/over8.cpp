#include "profiler/metrics/over8.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

// The threshold itself does not count as exceeded: differences of 8-bit images carry rounding in their last bits.
constexpr float kThreshold = 8.0f / 255.0f + 1e-6f;

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  std::size_t over = 0;
  bool finite = true;
  const std::size_t covered = visitCovered(*inputs.mask, [&](std::size_t pixel) {
    float largest = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const float difference = std::abs(cached[i] - original[i]);
      finite = finite && std::isfinite(difference);
      largest = std::max(largest, difference);
    }
    over += largest > kThreshold;
  });
  if (!finite) return std::numeric_limits<double>::quiet_NaN();
  return covered ? static_cast<double>(over) / static_cast<double>(covered) : 0;
}

}  // namespace

Metric over8Metric() {
  return {.name = "over8",
          .description = "share of covered pixels whose largest channel difference exceeds 8/255",
          .combination = SessionCombination::kMean,
          .evaluate = evaluate};
}

}  // namespace reprise

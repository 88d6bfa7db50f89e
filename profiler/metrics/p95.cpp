#include "profiler/metrics/p95.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  std::vector<float> differences;
  bool finite = true;
  visitCovered(*inputs.mask, [&](std::size_t pixel) {
    const std::size_t i = 3 * pixel;
    const float sum = std::abs(cached[i] - original[i]) + std::abs(cached[i + 1] - original[i + 1]) +
                      std::abs(cached[i + 2] - original[i + 2]);
    finite = finite && std::isfinite(sum);
    differences.push_back(sum / 3);
  });
  if (!finite) return std::numeric_limits<double>::quiet_NaN();  // has no rank
  if (differences.empty()) return 0;
  const std::size_t rank = (differences.size() * 95 + 99) / 100;
  std::nth_element(differences.begin(), differences.begin() + (rank - 1), differences.end());
  return differences[rank - 1];
}

}  // namespace

Metric p95Metric() {
  return {"p95", "95th percentile over covered pixels of the mean absolute channel difference",
          SessionCombination::kFrameMean, false, evaluate};
}

}  // namespace reprise

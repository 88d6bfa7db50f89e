#include "profiler/metrics/p95.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "profiler/metrics/covered_pixels.h"

namespace reprise {

namespace {

// The rank-th smallest (from 0) of values that are not negative: their bits are ordered as they are, so that counting by the
// upper half of the bits leaves few to select from.
float valueOfRank(std::size_t rank, const std::vector<float>& values) {
  const auto bin = [](float value) { return std::bit_cast<std::uint32_t>(value) >> 16; };
  std::vector<std::size_t> counts(std::size_t{1} << 16);
  for (const float value : values) ++counts[bin(value)];
  std::uint32_t chosen = 0;
  for (; rank >= counts[chosen]; ++chosen) rank -= counts[chosen];
  std::vector<float> candidates;
  candidates.reserve(counts[chosen]);
  for (const float value : values) {
    if (bin(value) == chosen) candidates.push_back(value);
  }
  std::nth_element(candidates.begin(), candidates.begin() + rank, candidates.end());
  return candidates[rank];
}

double evaluate(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  std::vector<float> differences;
  differences.reserve(inputs.mask->kind.size());
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
  return valueOfRank(rank - 1, differences);
}

}  // namespace

Metric p95Metric() {
  return {.name = "p95",
          .description = "95th percentile over covered pixels of the mean absolute channel difference",
          .combination = SessionCombination::kFrameMean,
          .evaluate = evaluate};
}

}  // namespace reprise

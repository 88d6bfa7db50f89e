#include "fitting/solve/paired_ratio.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/base/check.h"

namespace reprise {

namespace {

// splitmix64 (Steele, Lea, Flood 2014): the standard library's distributions differ between implementations.
class RandomIndex {
 public:
  explicit RandomIndex(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t count) {
    std::uint64_t bits = (state_ += 0x9e3779b97f4a7c15ull);
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ull;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebull;
    bits ^= bits >> 31;
    return static_cast<std::size_t>(((bits >> 32) * count) >> 32);
  }

 private:
  std::uint64_t state_;
};

double medianOf(std::vector<double>* values) {
  const std::size_t middle = values->size() / 2;
  std::nth_element(values->begin(), values->begin() + middle, values->end());
  const double upper = (*values)[middle];
  if (values->size() % 2 == 1) return upper;
  return (*std::max_element(values->begin(), values->begin() + middle) + upper) / 2;
}

// Nearest rank: the least value that is not exceeded by the share of all values.
double quantileOfSorted(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

void addBootstrapInterval(const std::vector<double>& ratios, const BootstrapOptions& options, PairedRatio* result) {
  RandomIndex random(options.seed);
  std::vector<double> medians, sample(ratios.size());
  medians.reserve(options.resamples);
  for (int i = 0; i < options.resamples; ++i) {
    for (double& value : sample) value = ratios[random.below(ratios.size())];
    medians.push_back(medianOf(&sample));
  }
  std::sort(medians.begin(), medians.end());
  result->lo = quantileOfSorted(medians, 0.025);
  result->hi = quantileOfSorted(medians, 0.975);
}

}  // namespace

PairedRatio pairedRatio(std::span<const double> original_ms, std::span<const double> variant_ms,
                        const BootstrapOptions& options) {
  REPRISE_CHECK(original_ms.size() == variant_ms.size(), original_ms.size(), variant_ms.size());
  REPRISE_CHECK(options.resamples >= 1, options.resamples);
  std::vector<double> ratios, originals, variants;
  for (std::size_t i = 0; i < original_ms.size(); ++i) {
    const double original = original_ms[i], variant = variant_ms[i];
    if (!(original > 0 && variant > 0 && std::isfinite(original) && std::isfinite(variant))) continue;
    ratios.push_back(original / variant);
    originals.push_back(original);
    variants.push_back(variant);
  }
  PairedRatio result;
  result.pairs = static_cast<int>(ratios.size());
  if (ratios.empty()) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {0, nan, nan, nan, nan, nan, nan, nan};
  }
  addBootstrapInterval(ratios, options, &result);
  result.ratio = medianOf(&ratios);
  result.original_median_ms = medianOf(&originals);
  result.variant_median_ms = medianOf(&variants);
  std::sort(variants.begin(), variants.end());
  result.variant_p95_ms = quantileOfSorted(variants, 0.95);
  result.variant_worst_ms = variants.back();
  return result;
}

}  // namespace reprise

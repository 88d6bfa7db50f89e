// Synthetic measurements with known parameters for the tests of fitting. Deterministic for a seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fitting/solve/fit_cost.h"
#include "fitting/solve/fit_error.h"

namespace reprise {

inline const std::vector<std::uint32_t> kPeriods = {2, 4, 8, 16, 32, 64};

class Noise {
 public:
  explicit Noise(std::uint32_t seed) : random_(seed) {}
  double uniform(double lo, double hi) { return lo + (hi - lo) * (random_() >> 8) / static_cast<double>(1 << 24); }
  // Approximately normal: the sum of twelve uniforms, so that it is the same on every standard library.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
    return sum;
  }

 private:
  std::mt19937 random_;
};

// Errors of a model with relative noise at the usual periods.
inline std::vector<ErrorPoint> errorPoints(const std::string& family, const std::vector<double>& parameters,
                                           double relative_noise, std::uint32_t seed) {
  Noise noise(seed);
  std::vector<ErrorPoint> points;
  for (const std::uint32_t period : kPeriods) {
    const double exact = findErrorModel(family)->value(parameters.data(), period);
    points.push_back({period, exact * (1 + relative_noise * noise.normal()), 0});
  }
  return points;
}

// Frames of a session whose coverage varies by a factor of three, at several hit rates; times scatter by relative_noise.
inline std::vector<CostPoint> costPoints(const CostParameters& cost, double relative_noise, std::uint32_t seed,
                                         int count = 120) {
  Noise noise(seed);
  std::vector<CostPoint> points;
  for (int i = 0; i < count; ++i) {
    const double fragments = noise.uniform(60'000, 200'000);
    const double hit_rate = i % 4 == 0 ? 0.5 : i % 4 == 1 ? 0.85 : noise.uniform(0.3, 0.97);
    const double hits = std::round(fragments * hit_rate), misses = std::round(fragments - hits);
    const double scatter = std::max(0.2, 1 + relative_noise * noise.normal());
    points.push_back({hits, misses, frameTimeMs(cost, hits, misses) * scatter});
  }
  return points;
}

}  // namespace reprise

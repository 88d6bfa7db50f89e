#include "fitting/solve/paired_ratio.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

struct Pairs {
  std::vector<double> original_ms, variant_ms;
};

// Both times of a pair share a drift of up to a factor of two, which pairing must cancel.
Pairs makePairs(double ratio, double scatter, int count, std::uint32_t seed) {
  Noise noise(seed);
  Pairs pairs;
  for (int i = 0; i < count; ++i) {
    const double drift = noise.uniform(1, 2);
    pairs.original_ms.push_back(20 * drift * ratio * (1 + scatter * noise.normal()));
    pairs.variant_ms.push_back(20 * drift * (1 + scatter * noise.normal()));
  }
  return pairs;
}

TEST(PairedRatio, OfKnownPairsIsTheMedianOfTheirRatios) {
  const std::vector<double> original = {10, 20, 30, 40}, variant = {5, 10, 10, 10};
  const PairedRatio result = pairedRatio(original, variant);
  EXPECT_EQ(result.pairs, 4);
  EXPECT_DOUBLE_EQ(result.ratio, 2.5);
  EXPECT_DOUBLE_EQ(result.original_median_ms, 25);
  EXPECT_DOUBLE_EQ(result.variant_median_ms, 10);
  EXPECT_DOUBLE_EQ(result.variant_worst_ms, 10);
  EXPECT_GE(result.lo, 2);
  EXPECT_LE(result.hi, 4);
}

TEST(PairedRatio, ReportsP95AndWorstOfTheVariant) {
  std::vector<double> original(100, 50), variant;
  for (int i = 1; i <= 100; ++i) variant.push_back(i);
  const PairedRatio result = pairedRatio(original, variant);
  EXPECT_DOUBLE_EQ(result.variant_p95_ms, 95);
  EXPECT_DOUBLE_EQ(result.variant_worst_ms, 100);
}

RC_GTEST_PROP(PairedRatio, CancelsDriftAndHoldsTheRatio, (std::uint32_t seed)) {
  const double ratio = *rc::gen::inRange(50, 400) / 100.0;
  const Pairs pairs = makePairs(ratio, 0.05, 40, seed);
  const PairedRatio result = pairedRatio(pairs.original_ms, pairs.variant_ms);
  RC_ASSERT(std::abs(result.ratio / ratio - 1) < 0.07);
  RC_ASSERT(result.lo <= result.ratio);
  RC_ASSERT(result.ratio <= result.hi);
}

TEST(PairedRatio, IntervalHoldsTheTruthAboutAsOftenAsItSays) {
  int held = 0;
  constexpr int kRuns = 300;
  for (std::uint32_t seed = 0; seed < kRuns; ++seed) {
    const Pairs pairs = makePairs(1.5, 0.1, 25, seed);
    const PairedRatio result = pairedRatio(pairs.original_ms, pairs.variant_ms, {.seed = seed, .resamples = 500});
    held += result.lo <= 1.5 && 1.5 <= result.hi;
  }
  EXPECT_GT(held, 0.9 * kRuns);
  EXPECT_LT(held, kRuns);
}

TEST(PairedRatio, IsDeterministicAndFollowsItsSeed) {
  const Pairs pairs = makePairs(1.2, 0.1, 20, 3);
  const PairedRatio a = pairedRatio(pairs.original_ms, pairs.variant_ms, {.seed = 5});
  const PairedRatio b = pairedRatio(pairs.original_ms, pairs.variant_ms, {.seed = 5});
  EXPECT_EQ(a.lo, b.lo);
  EXPECT_EQ(a.hi, b.hi);
  EXPECT_EQ(a.ratio, b.ratio);
  bool any_differs = false;
  for (std::uint64_t seed = 6; seed < 12; ++seed) {
    const PairedRatio other = pairedRatio(pairs.original_ms, pairs.variant_ms, {.seed = seed, .resamples = 50});
    any_differs = any_differs || other.lo != a.lo;
    EXPECT_EQ(other.ratio, a.ratio);
  }
  EXPECT_TRUE(any_differs);
}

TEST(PairedRatio, DropsPairsWithoutUsableTimes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PairedRatio result = pairedRatio(std::vector<double>{10, nan, 0, 30}, std::vector<double>{5, 5, 5, 10});
  EXPECT_EQ(result.pairs, 2);
  EXPECT_DOUBLE_EQ(result.ratio, 2.5);
}

TEST(PairedRatio, WithoutPairsIsNotANumber) {
  const PairedRatio result = pairedRatio({}, {});
  EXPECT_EQ(result.pairs, 0);
  EXPECT_TRUE(std::isnan(result.ratio));
  EXPECT_TRUE(std::isnan(result.lo));
}

}  // namespace
}  // namespace reprise

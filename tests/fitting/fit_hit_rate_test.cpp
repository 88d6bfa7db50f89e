#include "fitting/solve/fit_hit_rate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

RC_GTEST_PROP(FitHitRate, RecoversMuFromCounts, (std::uint32_t seed)) {
  const double mu = *rc::gen::inRange(1, 1000) / 1000.0;
  Noise noise(seed);
  std::vector<HitRatePoint> points;
  for (const std::uint32_t period : kPeriods) {
    const double covered = noise.uniform(1e5, 3e5);
    points.push_back({period, covered * hitRate(mu, period) * (1 + 0.01 * noise.normal()), covered});
  }
  points.push_back({0, 1e5 * mu, 1e5});
  const HitRateFit fit = fitHitRate(points);
  RC_ASSERT(fit.verdict == FitVerdict::kGood);
  RC_ASSERT(std::abs(fit.mu.value - mu) < 0.02 * mu);
  RC_ASSERT(fit.mu.lo <= fit.mu.value);
  RC_ASSERT(fit.mu.value <= fit.mu.hi);
  RC_ASSERT(fit.mu.hi <= 1.0);
}

TEST(HitRate, IsNothingAtPeriodOneAndMuForNever) {
  EXPECT_EQ(hitRate(0.9, 1), 0);
  EXPECT_DOUBLE_EQ(hitRate(0.9, 4), 0.675);
  EXPECT_DOUBLE_EQ(hitRate(0.9, 0), 0.9);
}

TEST(FitHitRate, OfOnePeriodMeetsIt) {
  const HitRateFit fit = fitHitRate(std::vector<HitRatePoint>{{8, 70, 100}});
  EXPECT_EQ(fit.verdict, FitVerdict::kFewPoints);
  EXPECT_DOUBLE_EQ(fit.mu.value, 0.8);
  EXPECT_EQ(fit.mu.lo, 0);
  EXPECT_EQ(fit.mu.hi, 1);
}

TEST(FitHitRate, WithoutCoveredPixelsIsAVerdict) {
  const HitRateFit fit = fitHitRate(std::vector<HitRatePoint>{{1, 0, 100}, {8, 0, 0}});
  EXPECT_EQ(fit.verdict, FitVerdict::kNoPoints);
}

TEST(FitHitRate, IsPoorWhereRatesDoNotFollowTheModel) {
  const HitRateFit fit = fitHitRate(std::vector<HitRatePoint>{{2, 90, 100}, {8, 10, 100}, {64, 60, 100}});
  EXPECT_EQ(fit.verdict, FitVerdict::kPoor);
}

TEST(FitHitRate, NeverExceedsOne) {
  EXPECT_EQ(fitHitRate(std::vector<HitRatePoint>{{2, 60, 100}, {4, 80, 100}}).mu.value, 1);
}

}  // namespace
}  // namespace reprise

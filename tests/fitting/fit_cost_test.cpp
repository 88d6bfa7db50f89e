#include "fitting/solve/fit_cost.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

CostParameters drawCost() {
  const auto draw = [](double lo, double hi) { return lo + (hi - lo) * *rc::gen::inRange(0, 1001) / 1000.0; };
  const double hit_ns = draw(10, 80);
  return {hit_ns, hit_ns + draw(20, 400), draw(0, 6)};
}

double relativeError(double value, double truth) {
  return std::abs(value / truth - 1);
}

RC_GTEST_PROP(FitCost, RecoversExactParameters, (std::uint32_t seed)) {
  const CostParameters cost = drawCost();
  const CostFit fit = fitCost(costPoints(cost, 0, seed));
  RC_ASSERT(fit.verdict == FitVerdict::kGood);
  RC_ASSERT(relativeError(fit.cost.hit_ns, cost.hit_ns) < 1e-3);
  RC_ASSERT(relativeError(fit.cost.miss_ns, cost.miss_ns) < 1e-3);
  RC_ASSERT(std::abs(fit.cost.overhead_ms - cost.overhead_ms) < 0.01);
  RC_ASSERT(fit.r_squared > 0.9999);
}

RC_GTEST_PROP(FitCost, PredictsFromTimesThatScatterByTenPercent, (std::uint32_t seed)) {
  const CostParameters cost = drawCost();
  const CostFit fit = fitCost(costPoints(cost, 0.1, seed));
  RC_ASSERT(isUsable(fit.verdict));
  RC_ASSERT(std::abs(fit.scatter - 0.1) < 0.05);
  for (const double hit_rate : {0.5, 0.75, 0.9}) {
    const double hits = 130'000 * hit_rate, misses = 130'000 - hits;
    RC_ASSERT(relativeError(predictFrameTime(fit, hits, misses), frameTimeMs(cost, hits, misses)) < 0.08);
  }
}

RC_GTEST_PROP(FitCost, IsNotMovedByOutliers, (std::uint32_t seed)) {
  const CostParameters cost = {30, 150, 2};
  std::vector<CostPoint> points = costPoints(cost, 0.05, seed);
  for (std::size_t i = 0; i < points.size(); i += 10) points[i].frame_time_ms *= 4;
  const CostFit fit = fitCost(points);
  RC_ASSERT(relativeError(predictFrameTime(fit, 100'000, 20'000), frameTimeMs(cost, 100'000, 20'000)) < 0.08);
}

// A parameter that is truly 0 lies on its bound, where solvers like to stall.
RC_GTEST_PROP(FitCost, ConvergesWhereParametersAreZero, (std::uint32_t seed)) {
  CostParameters cost = drawCost();
  if (*rc::gen::arbitrary<bool>()) cost.hit_ns = 0;
  cost.overhead_ms = 0;
  const double scatter = *rc::gen::element(0.0, 0.05, 0.15);
  const CostFit fit = fitCost(costPoints(cost, scatter, seed));
  RC_ASSERT(isUsable(fit.verdict));
  const double exact = frameTimeMs(cost, 80'000, 50'000);
  RC_ASSERT(relativeError(predictFrameTime(fit, 80'000, 50'000), exact) < 0.1);
}

RC_GTEST_PROP(FitCost, ParametersAreNeverNegative, (std::uint32_t seed)) {
  Noise noise(seed);
  std::vector<CostPoint> points;
  for (int i = 0; i < 30; ++i) {
    points.push_back({noise.uniform(0, 1e5), noise.uniform(0, 1e5), noise.uniform(0.1, 20)});
  }
  // Times that have nothing to do with the fragments may well not converge; negative they must not be.
  const CostFit fit = fitCost(points);
  RC_ASSERT(fit.cost.hit_ns >= 0.0);
  RC_ASSERT(fit.cost.miss_ns >= 0.0);
  RC_ASSERT(fit.cost.overhead_ms >= 0.0);
}

TEST(FitCost, IntervalsHoldTheTruthAboutAsOftenAsTheySay) {
  const CostParameters cost = {40, 200, 3};
  int held = 0;
  constexpr int kFits = 150;
  for (std::uint32_t seed = 0; seed < kFits; ++seed) {
    const CostFit fit = fitCost(costPoints(cost, 0.05, seed));
    EXPECT_EQ(fit.verdict, FitVerdict::kGood);
    held += fit.hit_ns.lo <= cost.hit_ns && cost.hit_ns <= fit.hit_ns.hi;
    held += fit.miss_ns.lo <= cost.miss_ns && cost.miss_ns <= fit.miss_ns.hi;
    held += fit.overhead_ms.lo <= cost.overhead_ms && cost.overhead_ms <= fit.overhead_ms.hi;
  }
  EXPECT_GT(held, 0.88 * 3 * kFits);
  EXPECT_LT(held, 3 * kFits);
}

std::vector<CostPoint> pointsOfConstantCoverage(const CostParameters& cost) {
  Noise noise(5);
  std::vector<CostPoint> points;
  for (int i = 0; i < 60; ++i) {
    const double hits = std::round(noise.uniform(20'000, 95'000)), misses = 100'000 - hits;
    points.push_back({hits, misses, frameTimeMs(cost, hits, misses) * (1 + 0.05 * noise.normal())});
  }
  return points;
}

TEST(FitCost, SaysThatCoverageDoesNotVaryAndPredictsThere) {
  const CostParameters cost = {30, 150, 2};
  const CostFit fit = fitCost(pointsOfConstantCoverage(cost));
  EXPECT_EQ(fit.verdict, FitVerdict::kUnidentifiable);
  EXPECT_NE(fit.explanation.find("unidentifiable: coverage does not vary"), std::string::npos) << fit.explanation;
  EXPECT_EQ(fit.cost.overhead_ms, 0);
  EXPECT_TRUE(std::isinf(fit.overhead_ms.hi));
  EXPECT_LT(relativeError(predictFrameTime(fit, 80'000, 20'000), frameTimeMs(cost, 80'000, 20'000)), 0.05);
}

TEST(FitCost, SaysThatTheShareOfMissesDoesNotVary) {
  const CostParameters cost = {30, 150, 2};
  Noise noise(6);
  std::vector<CostPoint> points;
  for (int i = 0; i < 60; ++i) {
    const double fragments = noise.uniform(30'000, 200'000);
    const double hits = 0.9 * fragments, misses = 0.1 * fragments;
    points.push_back({hits, misses, frameTimeMs(cost, hits, misses) * (1 + 0.05 * noise.normal())});
  }
  const CostFit fit = fitCost(points);
  EXPECT_EQ(fit.verdict, FitVerdict::kUnidentifiable);
  EXPECT_NE(fit.explanation.find("share of misses does not vary"), std::string::npos) << fit.explanation;
  EXPECT_EQ(fit.cost.hit_ns, fit.cost.miss_ns);
  EXPECT_LT(relativeError(predictFrameTime(fit, 90'000, 10'000), frameTimeMs(cost, 90'000, 10'000)), 0.05);
  EXPECT_NEAR(fit.cost.overhead_ms, 2, 0.8);
}

TEST(FitCost, SaysThatNothingVaries) {
  const std::vector<CostPoint> points(30, {90'000, 10'000, 6.0});
  const CostFit fit = fitCost(points);
  EXPECT_EQ(fit.verdict, FitVerdict::kUnidentifiable);
  EXPECT_NEAR(predictFrameTime(fit, 90'000, 10'000), 6, 1e-6);
}

TEST(FitCost, ScatterCanHideWhatVariesALittle) {
  // Coverage varies by 3%: enough for exact times, not for times that scatter by 20%.
  const CostParameters cost = {30, 150, 2};
  const auto points = [&](double scatter) {
    Noise noise(7);
    std::vector<CostPoint> result;
    for (int i = 0; i < 60; ++i) {
      const double fragments = noise.uniform(95'000, 105'000), hits = fragments * noise.uniform(0.3, 0.95);
      const double exact = frameTimeMs(cost, hits, fragments - hits);
      result.push_back({hits, fragments - hits, exact * (1 + scatter * noise.normal())});
    }
    return result;
  };
  EXPECT_EQ(fitCost(points(0)).verdict, FitVerdict::kGood);
  EXPECT_EQ(fitCost(points(0.2)).verdict, FitVerdict::kUnidentifiable);
}

TEST(FitCost, LeavesOutUnusableRows) {
  const CostParameters cost = {30, 150, 2};
  std::vector<CostPoint> points = costPoints(cost, 0, 1);
  const std::size_t usable = points.size();
  points.push_back({0, 0, 5});
  points.push_back({100, 100, 0});
  points.push_back({100, 100, std::numeric_limits<double>::quiet_NaN()});
  points.push_back({-5, 100, 5});
  const CostFit fit = fitCost(points);
  EXPECT_EQ(fit.residuals_ms.size(), usable);
  EXPECT_NEAR(fit.cost.miss_ns, 150, 0.1);
}

TEST(FitCost, WithoutRowsIsAVerdict) {
  const CostFit fit = fitCost({});
  EXPECT_EQ(fit.verdict, FitVerdict::kNoPoints);
  EXPECT_TRUE(std::isnan(predictFrameTime(fit, 1, 1)));
}

TEST(FitCost, WithoutConvergenceIsAVerdict) {
  const CostFit fit = fitCost(costPoints({30, 150, 2}, 0.1, 1), {.max_iterations = 0});
  EXPECT_EQ(fit.verdict, FitVerdict::kNotConverged);
  EXPECT_TRUE(std::isnan(predictFrameTime(fit, 1, 1)));
}

TEST(FitCost, OfTimesWithoutOrderIsPoorOrUnidentifiable) {
  const CostFit fit = fitCost(costPoints({30, 150, 2}, 0.6, 4));
  EXPECT_TRUE(fit.verdict == FitVerdict::kPoor || fit.verdict == FitVerdict::kUnidentifiable);
  EXPECT_GT(fit.scatter, 0.3);
}

}  // namespace
}  // namespace reprise

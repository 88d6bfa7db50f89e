#include "fitting/solve/fit_error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

double drawBetween(double lo, double hi) {
  const double unit = *rc::gen::inRange(0, 10'001) / 10'000.0;
  return lo * std::pow(hi / lo, unit);
}

struct KnownModel {
  std::string family;
  std::vector<double> parameters;
};

// Parameters that six periods can tell from the other families.
KnownModel drawKnownModel() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0: return {"exponential", {drawBetween(0.005, 0.5), drawBetween(0.03, 0.3)}};
    case 1: return {"power", {drawBetween(0.002, 0.05), drawBetween(0.25, 0.7)}};
    case 2: return {"logarithm", {drawBetween(0.002, 0.1)}};
    default: return {"constant", {drawBetween(0.001, 0.5)}};
  }
}

RC_GTEST_PROP(FitError, RecoversExactParameters, ()) {
  const KnownModel known = drawKnownModel();
  const ErrorFit fit = fitErrorModel(errorPoints(known.family, known.parameters, 0, 1));
  RC_ASSERT(fit.verdict == FitVerdict::kGood);
  RC_ASSERT(fit.family == known.family);
  for (std::size_t i = 0; i < known.parameters.size(); ++i) {
    RC_ASSERT(std::abs(fit.parameters[i].value / known.parameters[i] - 1) < 1e-3);
  }
  RC_ASSERT(fit.r_squared > 0.9999);
}

RC_GTEST_PROP(FitError, RecoversParametersFromNoisyPoints, (std::uint32_t seed)) {
  const KnownModel known = drawKnownModel();
  const ErrorFitOptions options{.family = known.family};
  const ErrorFit fit = fitErrorModel(errorPoints(known.family, known.parameters, 0.03, seed), options);
  RC_ASSERT(isUsable(fit.verdict));
  const ErrorModel& model = *findErrorModel(known.family);
  // Where the parameters are strongly correlated their values may move together; the curve may not.
  for (const std::uint32_t period : kPeriods) {
    const double exact = model.value(known.parameters.data(), period);
    RC_ASSERT(std::abs(predictError(fit, period).value / exact - 1) < 0.15);
  }
  if (known.family != "exponential") {
    for (std::size_t i = 0; i < known.parameters.size(); ++i) {
      RC_ASSERT(std::abs(fit.parameters[i].value / known.parameters[i] - 1) < 0.25);
    }
  }
}

RC_GTEST_PROP(FitError, PredictsWithinAFewPercentWhateverItPicks, (std::uint32_t seed)) {
  const KnownModel known = drawKnownModel();
  const ErrorFit fit = fitErrorModel(errorPoints(known.family, known.parameters, 0.03, seed));
  RC_ASSERT(isUsable(fit.verdict));
  for (const std::uint32_t period : kPeriods) {
    const double exact = findErrorModel(known.family)->value(known.parameters.data(), period);
    RC_ASSERT(std::abs(predictError(fit, period).value / exact - 1) < 0.2);
  }
}

TEST(FitError, IntervalsHoldTheTruthAboutAsOftenAsTheySay) {
  const std::vector<double> parameters = {0.01, 0.4};
  int held = 0, predicted = 0, all = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const ErrorFit fit = fitErrorModel(errorPoints("power", parameters, 0.05, seed), {.family = "power"});
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      held += fit.parameters[i].lo <= parameters[i] && parameters[i] <= fit.parameters[i].hi;
      ++all;
    }
    const ErrorPrediction prediction = predictError(fit, 8);
    const double exact = findErrorModel("power")->value(parameters.data(), 8);
    predicted += prediction.lo <= exact && exact <= prediction.hi;
  }
  EXPECT_GT(held, 0.88 * all);
  EXPECT_LT(held, all);
  EXPECT_GT(predicted, 0.9 * 300);
}

RC_GTEST_PROP(FitError, PredictionsNeverFallWithThePeriod, (std::uint32_t seed)) {
  // Even where the measured errors do.
  Noise noise(seed);
  std::vector<ErrorPoint> points;
  for (const std::uint32_t period : kPeriods) points.push_back({period, noise.uniform(0, 0.2), 0});
  const ErrorFit fit = fitErrorModel(points);
  RC_ASSERT(isUsable(fit.verdict));
  double last = 0;
  for (std::uint32_t period = 1; period <= 256; ++period) {
    const ErrorPrediction prediction = predictError(fit, period);
    RC_ASSERT(prediction.value >= last);
    RC_ASSERT(prediction.lo <= prediction.value);
    RC_ASSERT(prediction.value <= prediction.hi);
    RC_ASSERT(prediction.hi <= 1.0);
    last = prediction.value;
  }
  RC_ASSERT(predictError(fit, 1).value == 0.0);
}

TEST(FitError, PicksPowerForMeasuredBilinearErrorsAndNotEquation4) {
  // Bilinear resampling of a marble (error x 10^-3 at periods 2, 8, 16, 64).
  const std::vector<ErrorPoint> points = {{2, 0.007}, {4, 0.0105}, {8, 0.014}, {16, 0.018}, {64, 0.027}};
  const ErrorFit fit = fitErrorModel(points);
  EXPECT_EQ(fit.family, "power");
  EXPECT_NEAR(fit.parameters[1].value, 0.35, 0.1);
  EXPECT_GT(fit.r_squared, 0.98);
}

TEST(FitError, OfZeroErrorsIsTheConstantZero) {
  const std::vector<ErrorPoint> points = {{2, 0}, {8, 0}, {64, 0}};
  const ErrorFit fit = fitErrorModel(points);
  EXPECT_EQ(fit.family, "constant");
  EXPECT_EQ(fit.verdict, FitVerdict::kGood);
  EXPECT_EQ(predictError(fit, 32).value, 0);
  EXPECT_EQ(predictError(fit, 32).hi, 0);
}

TEST(FitError, ReadsRightFromAFewPoints) {
  const double one[] = {0.01};
  for (const std::string family : {"logarithm", "constant"}) {
    const ErrorModel& model = *findErrorModel(family);
    const std::vector<ErrorPoint> two = {{4, model.value(one, 4)}, {16, model.value(one, 16)}};
    const ErrorFit fit = fitErrorModel(two);
    EXPECT_EQ(fit.family, family);
    EXPECT_EQ(fit.verdict, FitVerdict::kGood);
    EXPECT_NEAR(predictError(fit, 64).value, model.value(one, 64), 1e-5);
  }
  const double power[] = {0.007, 0.35};
  const ErrorModel& model = *findErrorModel("power");
  for (const std::vector<std::uint32_t>& periods : {std::vector<std::uint32_t>{2, 16}, {2, 8, 64}}) {
    std::vector<ErrorPoint> points;
    for (const std::uint32_t period : periods) points.push_back({period, model.value(power, period)});
    const ErrorFit fit = fitErrorModel(points);
    EXPECT_EQ(fit.family, "power") << periods.size();
    EXPECT_NEAR(predictError(fit, 32).value, model.value(power, 32), 0.1 * model.value(power, 32));
    const bool exact = points.size() == 2;
    EXPECT_EQ(fit.verdict, exact ? FitVerdict::kFewPoints : FitVerdict::kGood);
    EXPECT_GT(predictError(fit, 32).hi, 1.05 * predictError(fit, 32).value) << "points met exactly prove nothing";
  }
}

TEST(FitError, OfOnePointIsUsableAndSaysThatNothingVouchesForIt) {
  const std::vector<ErrorPoint> points = {{8, 0.02}};
  const ErrorFit fit = fitErrorModel(points);
  EXPECT_EQ(fit.verdict, FitVerdict::kFewPoints);
  EXPECT_NEAR(predictError(fit, 8).value, 0.02, 1e-6);
}

TEST(FitError, LeavesOutNeverAndPeriodOneAndWhatIsNotFinite) {
  std::vector<ErrorPoint> points = errorPoints("logarithm", {0.01}, 0, 1);
  points.push_back({0, 0.9});
  points.push_back({1, 0.5});
  points.push_back({8, std::numeric_limits<double>::quiet_NaN()});
  points.push_back({8, -1});
  const ErrorFit fit = fitErrorModel(points);
  EXPECT_EQ(fit.points.size(), kPeriods.size());
  EXPECT_NEAR(fit.parameters[0].value, 0.01, 1e-5);
}

TEST(FitError, WithoutUsablePointsIsAVerdict) {
  const ErrorFit fit = fitErrorModel(std::vector<ErrorPoint>{{0, 0.1}, {1, 0.1}});
  EXPECT_EQ(fit.verdict, FitVerdict::kNoPoints);
  EXPECT_FALSE(fit.explanation.empty());
  EXPECT_TRUE(std::isnan(predictError(fit, 8).value));
}

TEST(FitError, WithoutConvergenceIsAVerdict) {
  const std::vector<ErrorPoint> points = errorPoints("exponential", {0.3, 0.123}, 0.1, 3);
  const ErrorFit fit = fitErrorModel(points, {.family = "exponential", .max_iterations = 1});
  EXPECT_EQ(fit.verdict, FitVerdict::kNotConverged);
  EXPECT_TRUE(std::isnan(predictError(fit, 8).value));
  EXPECT_EQ(fitErrorModel(points, {.family = "exponential"}).verdict, FitVerdict::kGood);
}

TEST(FitError, OfErrorsWithoutOrderIsPoor) {
  const std::vector<ErrorPoint> points = {{2, 0.2}, {4, 0.01}, {8, 0.15}, {16, 0.008}, {32, 0.21}, {64, 0.012}};
  EXPECT_EQ(fitErrorModel(points).verdict, FitVerdict::kPoor);
}

TEST(FitError, TrustsPointsBySigma) {
  // The last point is far off the logarithm and said to be uncertain.
  std::vector<ErrorPoint> points = errorPoints("logarithm", {0.01}, 0, 1);
  for (ErrorPoint& point : points) point.sigma = 0.0005;
  points.back().error *= 2;
  const double trusted = fitErrorModel(points, {.family = "logarithm"}).parameters[0].value;
  points.back().sigma = 0.1;
  const double doubted = fitErrorModel(points, {.family = "logarithm"}).parameters[0].value;
  EXPECT_NEAR(doubted, 0.01, 1e-4);
  EXPECT_GT(trusted, 0.012);
}

TEST(FitError, IsDeterministic) {
  const std::vector<ErrorPoint> points = errorPoints("exponential", {0.3, 0.05}, 0.05, 9);
  const ErrorFit a = fitErrorModel(points), b = fitErrorModel(points);
  EXPECT_EQ(a.family, b.family);
  EXPECT_EQ(a.parameters, b.parameters);
  EXPECT_EQ(a.covariance, b.covariance);
}

}  // namespace
}  // namespace reprise

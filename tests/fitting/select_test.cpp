// Selection on synthetic tables, held against plain searches over the same numbers (law 7).
#include "fitting/selection/select.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

struct KnownConfiguration {
  double power_scale = 0.01, power_exponent = 0.4, mu = 0.95;
  CostParameters cost{30, 150, 1};
  double fragments = 100'000;
  double never_error = 0.1;
};

Configuration makeConfiguration(const KnownConfiguration& known) {
  Configuration configuration;
  configuration.error_fit =
      fitErrorModel(errorPoints("power", {known.power_scale, known.power_exponent}, 0, 1), {.family = "power"});
  configuration.hit_rate.mu.value = known.mu;
  configuration.hit_rate.verdict = FitVerdict::kGood;
  configuration.cost.cost = known.cost;
  configuration.cost.verdict = FitVerdict::kGood;
  configuration.fragments_per_frame = known.fragments;
  for (const std::uint32_t period : kPeriods) configuration.periods.push_back({period, {}});
  configuration.periods.push_back({0, known.never_error});
  return configuration;
}

double drawBetween(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 1001) / 1000.0;
}

SelectionInput drawInput() {
  SelectionInput input;
  input.original_frame_ms = drawBetween(5, 25);
  const int count = *rc::gen::inRange(0, 8);
  for (int i = 0; i < count; ++i) {
    KnownConfiguration known;
    known.power_scale = drawBetween(0.001, 0.05);
    known.power_exponent = drawBetween(0.1, 0.8);
    known.mu = drawBetween(0.3, 1);
    // Hits may be dearer than misses.
    known.cost = {drawBetween(10, 200), drawBetween(50, 250), drawBetween(0, 3)};
    known.never_error = drawBetween(0, 0.2);
    input.configurations.push_back(makeConfiguration(known));
  }
  return input;
}

// What the header says about a point, computed anew.
struct PlainPoint {
  std::size_t configuration;
  std::uint32_t period_frames;
  double error, frame_ms;
};

std::vector<PlainPoint> allPoints(const SelectionInput& input) {
  std::vector<PlainPoint> points;
  for (std::size_t i = 0; i < input.configurations.size(); ++i) {
    const Configuration& c = input.configurations[i];
    for (const AllowedPeriod& allowed : c.periods) {
      const double error =
          allowed.period_frames == 0 ? *allowed.measured_error : predictError(c.error_fit, allowed.period_frames).value;
      const double rate = c.hit_rate.mu.value * (allowed.period_frames == 0 ? 1 : 1 - 1.0 / allowed.period_frames);
      const double per_fragment_ns = rate * c.cost.cost.hit_ns + (1 - rate) * c.cost.cost.miss_ns;
      points.push_back({i, allowed.period_frames, error,
                        per_fragment_ns * c.fragments_per_frame * 1e-6 + c.cost.cost.overhead_ms});
    }
  }
  return points;
}

RC_GTEST_PROP(Select, PicksTheExhaustiveOptimum, ()) {
  const SelectionInput input = drawInput();
  const SelectionOptions options{.threshold = drawBetween(0.002, 0.2), .error_margin = drawBetween(0, 0.5)};
  const Selection selection = select(input, options).value();
  double best_ms = std::numeric_limits<double>::infinity();
  for (const PlainPoint& point : allPoints(input)) {
    const bool acceptable = point.error <= options.threshold * (1 - options.error_margin);
    if (acceptable && point.frame_ms < input.original_frame_ms) best_ms = std::min(best_ms, point.frame_ms);
  }
  if (std::isinf(best_ms)) {
    RC_ASSERT(selection.ranking.empty());
    RC_ASSERT(!selection.original_reason_code.empty());
    RC_ASSERT(!selection.original_reason.empty());
  } else {
    RC_ASSERT(!selection.ranking.empty());
    RC_ASSERT(std::abs(selection.ranking[0].predicted_frame_ms - best_ms) < 1e-9);
    RC_ASSERT(selection.original_reason_code.empty());
  }
}

RC_GTEST_PROP(Select, RanksOnlyWhatKeepsTheThresholdAndIsFaster, (bool shorter_periods)) {
  const SelectionInput input = drawInput();
  const SelectionOptions options{.threshold = drawBetween(0.002, 0.2), .error_margin = 0.1, .shorter_periods = shorter_periods};
  const Selection selection = select(input, options).value();
  for (std::size_t i = 0; i < selection.ranking.size(); ++i) {
    const TradeoffPoint& point = selection.ranking[i];
    RC_ASSERT(point.predicted_error <= options.threshold * 0.9);
    RC_ASSERT(point.predicted_frame_ms < input.original_frame_ms);
    if (i > 0) RC_ASSERT(selection.ranking[i - 1].predicted_frame_ms <= point.predicted_frame_ms);
  }
  // Each configuration is ranked or dropped with a reason, never both or neither.
  for (std::size_t index = 0; index < input.configurations.size(); ++index) {
    const auto ranked = std::count_if(selection.ranking.begin(), selection.ranking.end(),
                                      [&](const TradeoffPoint& point) { return point.configuration == index; });
    const auto dropped = std::count_if(selection.dropped.begin(), selection.dropped.end(),
                                       [&](const DroppedConfiguration& drop) { return drop.configuration == index; });
    RC_ASSERT(dropped == (ranked == 0 ? 1 : 0));
    if (!shorter_periods) RC_ASSERT(ranked <= 1);
  }
}

RC_GTEST_PROP(Select, ParetoFrontHoldsExactlyTheUnbeaten, ()) {
  const SelectionInput input = drawInput();
  const Selection selection = select(input, {.threshold = 0.05}).value();
  const std::vector<PlainPoint> points = allPoints(input);
  RC_ASSERT(selection.points.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    RC_ASSERT(selection.points[i].period_frames == points[i].period_frames);
    RC_ASSERT(std::abs(selection.points[i].predicted_error - points[i].error) < 1e-12);
    RC_ASSERT(std::abs(selection.points[i].predicted_frame_ms - points[i].frame_ms) < 1e-9);
  }
  // By the numbers reported: points that differ by rounding only must not be judged by other roundings.
  const auto isBeaten = [&](double error, double frame_ms) {
    return std::any_of(selection.points.begin(), selection.points.end(), [&](const TradeoffPoint& other) {
      return other.predicted_error <= error && other.predicted_frame_ms <= frame_ms &&
             (other.predicted_error < error || other.predicted_frame_ms < frame_ms);
    });
  };
  std::size_t unbeaten = 0;
  for (const TradeoffPoint& point : selection.points) {
    const bool in_front =
        std::find(selection.pareto.begin(), selection.pareto.end(), point) != selection.pareto.end();
    RC_ASSERT(in_front == !isBeaten(point.predicted_error, point.predicted_frame_ms));
    unbeaten += in_front;
  }
  RC_ASSERT(unbeaten == selection.pareto.size());
  for (std::size_t i = 1; i < selection.pareto.size(); ++i) {
    RC_ASSERT(selection.pareto[i - 1].predicted_error < selection.pareto[i].predicted_error);
    RC_ASSERT(selection.pareto[i - 1].predicted_frame_ms > selection.pareto[i].predicted_frame_ms);
  }
}

TEST(Select, TakesTheLargestPeriodUnderTheThreshold) {
  const SelectionInput input{{makeConfiguration({})}, 20};
  // 0.01 (n - 1)^0.4 is 0.0218 at 8 and 0.0295 at 16.
  const Selection selection = select(input, {.threshold = 0.025, .error_margin = 0.1}).value();
  ASSERT_EQ(selection.ranking.size(), 1u);
  EXPECT_EQ(selection.ranking[0].period_frames, 8u);
  EXPECT_NEAR(selection.ranking[0].predicted_error, 0.0218, 1e-4);
  EXPECT_FALSE(selection.ranking[0].error_measured);
  EXPECT_EQ(select(input, {.threshold = 0.0235, .error_margin = 0.1})->ranking[0].period_frames, 4u);
}

TEST(Select, KnowsNeverByItsMeasuredErrorOnly) {
  Configuration configuration = makeConfiguration({.never_error = 0.01});
  const SelectionInput measured{{configuration}, 20};
  const Selection selection = select(measured, {.threshold = 0.02}).value();
  EXPECT_EQ(selection.ranking.at(0).period_frames, 0u);
  EXPECT_TRUE(selection.ranking[0].error_measured);
  EXPECT_EQ(selection.ranking[0].predicted_error, 0.01);
  EXPECT_EQ(selection.points.back().period_frames, 0u);

  configuration.periods.back().measured_error.reset();
  const SelectionInput unmeasured{{configuration}, 20};
  for (const TradeoffPoint& point : select(unmeasured, {.threshold = 1})->points) EXPECT_NE(point.period_frames, 0u);
}

TEST(Select, PrefersAMeasuredErrorToThePrediction) {
  Configuration configuration = makeConfiguration({});
  for (AllowedPeriod& allowed : configuration.periods) {
    if (allowed.period_frames == 64) allowed.measured_error = 0.001;
  }
  const SelectionInput input{{configuration}, 20};
  EXPECT_EQ(select(input, {.threshold = 0.02})->ranking.at(0).period_frames, 64u);
}

TEST(Select, SaysThatEveryVariantIsTooSlow) {
  const SelectionInput input{{makeConfiguration({}), makeConfiguration({.mu = 0.5})}, 2};
  const Selection selection = select(input, {.threshold = 0.5}).value();
  EXPECT_TRUE(selection.ranking.empty());
  EXPECT_EQ(selection.original_reason_code, "selection.slow");
  EXPECT_EQ(selection.dropped.size(), 2u);
  EXPECT_FALSE(selection.pareto.empty());
}

TEST(Select, SaysThatEveryErrorIsTooLarge) {
  const SelectionInput input{{makeConfiguration({})}, 20};
  const Selection selection = select(input, {.threshold = 0.001}).value();
  EXPECT_EQ(selection.original_reason_code, "selection.error");
  EXPECT_EQ(selection.dropped.at(0).code, "selection.error");
}

TEST(Select, PassesOverConfigurationsWithoutModels) {
  Configuration without_error = makeConfiguration({}), without_cost = without_error, without_rate = without_error;
  without_error.error_fit.verdict = FitVerdict::kNotConverged;
  without_error.periods.pop_back();
  without_cost.cost.verdict = FitVerdict::kNoPoints;
  without_rate.hit_rate.verdict = FitVerdict::kNoPoints;
  const SelectionInput input{{without_error, without_cost, without_rate}, 20};
  const Selection selection = select(input, {.threshold = 0.5}).value();
  EXPECT_TRUE(selection.points.empty());
  EXPECT_EQ(selection.original_reason_code, "selection.no_model");
  EXPECT_EQ(selection.dropped.size(), 3u);
}

TEST(Select, OfNothingIsTheOriginal) {
  const Selection selection = select({{}, 20}, {.threshold = 0.02}).value();
  EXPECT_TRUE(selection.ranking.empty());
  EXPECT_EQ(selection.original_reason_code, "selection.no_candidates");
}

TEST(Select, OffersShorterPeriodsAsFurtherAttempts) {
  const SelectionInput input{{makeConfiguration({})}, 20};
  const Selection selection = select(input, {.threshold = 0.025, .shorter_periods = true}).value();
  ASSERT_EQ(selection.ranking.size(), 3u);
  EXPECT_EQ(selection.ranking[0].period_frames, 8u);
  EXPECT_EQ(selection.ranking[1].period_frames, 4u);
  EXPECT_EQ(selection.ranking[2].period_frames, 2u);
}

TEST(Select, RefusesBadOptions) {
  const SelectionInput input{{makeConfiguration({})}, 20};
  const auto codeOf = [](const Result<Selection>& result) { return result.ok() ? "" : result.error().code; };
  EXPECT_EQ(codeOf(select(input, {.threshold = -0.1})), "selection.threshold");
  EXPECT_EQ(codeOf(select(input, {.threshold = std::nan("")})), "selection.threshold");
  EXPECT_EQ(codeOf(select(input, {.threshold = 0.1, .error_margin = 1})), "selection.margin");
  EXPECT_EQ(codeOf(select({{}, 0}, {.threshold = 0.1})), "selection.original");
}

}  // namespace
}  // namespace reprise

// Law 7: a choice is accepted only if its measured error keeps the threshold and it is faster beyond the noise by both clocks.
#include "fitting/selection/judge.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace reprise {
namespace {

ValidationResult goodResult() {
  ValidationResult result;
  result.measured_error = 0.015;
  result.binding = {20, 2.0, 1.9, 2.1, 20, 10, 11, 12};
  result.wall = {20, 1.8, 1.6, 2.0, 20, 11, 12, 14};
  result.clock = "process_cpu";
  return result;
}

std::string codeOf(const ValidationResult& result, double threshold = 0.02) {
  const Judgement judgement = judge(result, threshold);
  EXPECT_EQ(judgement.accepted, judgement.code == "judge.accepted");
  EXPECT_FALSE(judgement.reason.empty());
  return judgement.code;
}

TEST(Judge, AcceptsWhatKeepsTheThresholdAndIsFaster) {
  EXPECT_EQ(codeOf(goodResult()), "judge.accepted");
  EXPECT_EQ(codeOf(goodResult(), 0.015), "judge.accepted") << "the threshold itself is allowed";
}

TEST(Judge, RejectsAnErrorAboveTheThreshold) {
  EXPECT_EQ(codeOf(goodResult(), 0.0149), "judge.error");
}

TEST(Judge, RejectsASpeedUpWithinTheNoise) {
  ValidationResult result = goodResult();
  result.binding = {20, 1.1, 0.98, 1.2, 20, 18, 19, 20};
  EXPECT_EQ(codeOf(result), "judge.not_faster");
}

TEST(Judge, RejectsWhatIsNotFasterByWallTime) {
  ValidationResult result = goodResult();
  result.wall = {20, 1.05, 0.9, 1.2, 20, 19, 21, 24};
  EXPECT_EQ(codeOf(result), "judge.wall_not_faster");
}

TEST(Judge, RejectsPixelsMadeNonFinite) {
  ValidationResult result = goodResult();
  result.nonfinite_pixels = 1;
  EXPECT_EQ(codeOf(result), "judge.nonfinite");
}

TEST(Judge, RejectsWhatWasNotMeasured) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ValidationResult result = goodResult();
  result.measured_error = nan;
  EXPECT_EQ(codeOf(result), "judge.unmeasured");
  result = goodResult();
  result.wall = {0, nan, nan, nan, nan, nan, nan, nan};
  EXPECT_EQ(codeOf(result), "judge.unmeasured");
  EXPECT_EQ(codeOf(goodResult(), nan), "judge.error") << "a threshold that is not a number allows nothing";
}

RC_GTEST_PROP(Judge, NeverBreaksItsWord, ()) {
  const auto draw = [](double hi) { return hi * *rc::gen::inRange(0, 101) / 100.0; };
  ValidationResult result;
  result.measured_error = draw(0.04);
  const double threshold = draw(0.04);
  for (PairedRatio* ratio : {&result.binding, &result.wall}) {
    ratio->pairs = *rc::gen::inRange(0, 3);
    ratio->lo = draw(2);
    ratio->ratio = ratio->lo + draw(1);
    ratio->hi = ratio->ratio + draw(1);
  }
  const bool keeps_word = result.measured_error <= threshold && result.binding.pairs > 0 && result.wall.pairs > 0 &&
                          result.binding.lo > 1 && result.wall.lo > 1;
  RC_ASSERT(judge(result, threshold).accepted == keeps_word);
}

TEST(Promise, OneThatIsKeptEndsTheSearch) { EXPECT_FALSE(worthAnother({2.0, 1.9}, 1.99)); }

TEST(Promise, ABrokenOneGivesTheNextItsTurn) { EXPECT_TRUE(worthAnother({2.4, 1.9}, 2.3)); }

TEST(Promise, NobodyIsAskedWhoPromisesLess) { EXPECT_FALSE(worthAnother({2.4, 1.9}, 1.8)); }

}  // namespace
}  // namespace reprise

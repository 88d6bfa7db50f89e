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
  result.errors = {{"rms", 0.015, 0.02}, {"blocks", 0.004, 0.008}};
  result.binding = {20, 2.0, 1.9, 2.1, 20, 10, 11, 12};
  result.wall = {20, 1.8, 1.6, 2.0, 20, 11, 12, 14};
  result.clock = "process_cpu";
  return result;
}

std::string codeOf(const ValidationResult& result, double least_gain = 1) {
  const Judgement judgement = judge(result, least_gain);
  EXPECT_EQ(judgement.accepted, judgement.code == "judge.accepted");
  EXPECT_FALSE(judgement.reason.empty());
  return judgement.code;
}

TEST(Judge, AcceptsWhatKeepsTheThresholdAndIsFaster) {
  EXPECT_EQ(codeOf(goodResult()), "judge.accepted");
  ValidationResult result = goodResult();
  result.errors[0].allowed = 0.015;
  EXPECT_EQ(codeOf(result), "judge.accepted") << "the threshold itself is allowed";
}

TEST(Judge, RejectsAnErrorAboveAnyThresholdAndNamesIt) {
  for (const std::size_t which : {0u, 1u}) {
    ValidationResult result = goodResult();
    result.errors[which].allowed = 0.0039;
    EXPECT_EQ(codeOf(result), "judge.error");
    EXPECT_NE(judge(result).reason.find(result.errors[which].metric + " " + (which == 0 ? "0.015" : "0.004") + " exceeds 0.0039"), std::string::npos) << judge(result).reason;
    EXPECT_EQ(judgeErrors(result).code, "judge.error") << "nothing need be timed for that";
  }
  EXPECT_EQ(judgeErrors(goodResult()).code, "");
}

// [1.9, 2.1] by the clock and [1.6, 2.0] by wall time.
TEST(Judge, HoldsTheLowEndsAgainstTheLeastGain) {
  EXPECT_EQ(codeOf(goodResult(), 1.59), "judge.accepted");
  EXPECT_EQ(codeOf(goodResult(), 1.7), "judge.wall_straddles");
  EXPECT_EQ(codeOf(goodResult(), 2.05), "judge.straddles");
  EXPECT_EQ(codeOf(goodResult(), 2.2), "judge.not_faster");
}

TEST(Judge, RejectsASpeedUpWithinTheNoise) {
  ValidationResult result = goodResult();
  result.binding = {20, 1.1, 0.98, 1.2, 20, 18, 19, 20};
  EXPECT_EQ(codeOf(result), "judge.straddles");
}

TEST(Judge, RejectsWhatIsNotFasterByWallTime) {
  ValidationResult result = goodResult();
  result.wall = {20, 0.95, 0.9, 0.99, 20, 19, 21, 24};
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
  result.errors[1].measured = nan;
  EXPECT_EQ(codeOf(result), "judge.unmeasured");
  result = goodResult();
  result.wall = {0, nan, nan, nan, nan, nan, nan, nan};
  EXPECT_EQ(codeOf(result), "judge.unmeasured");
  result = goodResult();
  result.errors.clear();
  EXPECT_EQ(codeOf(result), "judge.unmeasured") << "nothing binds";
  result = goodResult();
  result.errors[0].allowed = nan;
  EXPECT_EQ(codeOf(result), "judge.error") << "a threshold that is not a number allows nothing";
}

RC_GTEST_PROP(Judge, NeverBreaksItsWord, ()) {
  const auto draw = [](double hi) { return hi * *rc::gen::inRange(0, 101) / 100.0; };
  ValidationResult result;
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i) result.errors.push_back({"rms", draw(0.04), draw(0.04)});
  const double least_gain = 1 + draw(0.3);
  for (PairedRatio* ratio : {&result.binding, &result.wall}) {
    ratio->pairs = *rc::gen::inRange(0, 3);
    ratio->lo = draw(2);
    ratio->ratio = ratio->lo + draw(1);
    ratio->hi = ratio->ratio + draw(1);
  }
  bool keeps_word = result.binding.pairs > 0 && result.wall.pairs > 0 && result.binding.lo > least_gain && result.wall.lo > least_gain;
  for (const JudgedError& error : result.errors) keeps_word = keeps_word && error.measured <= error.allowed;
  RC_ASSERT(judge(result, least_gain).accepted == keeps_word);
}

TEST(Promise, OneThatIsKeptEndsTheSearch) { EXPECT_FALSE(worthAnother({2.0, 1.9}, 1.99)); }

TEST(Promise, ABrokenOneGivesTheNextItsTurn) { EXPECT_TRUE(worthAnother({2.4, 1.9}, 2.3)); }

TEST(Promise, NobodyIsAskedWhoPromisesLess) { EXPECT_FALSE(worthAnother({2.4, 1.9}, 1.8)); }

}  // namespace
}  // namespace reprise

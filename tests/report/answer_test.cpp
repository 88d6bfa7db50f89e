// What is answered where no variant was accepted.
#include "cli/answer.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

const Selection kNothingSelected;

RunResult runWithErrors(std::initializer_list<double> errors) {
  RunResult run;
  run.thresholds = {{"rms", 0.02}};
  run.threshold = {"rms", 0.02};
  run.original.frame_ms = 12;
  RunCandidate candidate;
  candidate.id = "light@worst.frag:38";
  candidate.name = "light";
  candidate.status = CandidateStatus::kTrained;
  RunConfiguration configuration;
  configuration.strategy = "two_pass";
  std::uint32_t period = 2;
  for (const double error : errors) {
    RunPoint point;
    point.period_frames = period;
    point.measured_error = error;
    configuration.points.push_back(point);
    period *= 2;
  }
  candidate.configurations.push_back(configuration);
  run.candidates.push_back(candidate);
  return run;
}

RunAttempt failedAttempt(const std::string& reason) {
  RunAttempt attempt;
  attempt.candidate_id = "light@worst.frag:38";
  attempt.configuration = "two_pass, interleaved 16x16, bilinear, rgba16f";
  attempt.period_frames = 8;
  attempt.measured_error = 0.01;
  attempt.measured_speedup = 1.02;
  attempt.speedup_ci95 = RunInterval{0.99, 1.05};
  attempt.reason = reason;
  return attempt;
}

TEST(Answer, IsTheOriginalWithTheLeastErrorWhereNoneIsSmallEnough) {
  const Answer answer = answerWithoutVariant(runWithErrors({0.036, 0.045}), {kNothingSelected});
  EXPECT_EQ(answer.kind, ChoiceKind::kOriginal);
  EXPECT_EQ(answer.reason, "no trained value keeps rms 0.02: the least error is 0.0360 rms, of 'light' refreshed every 2 frames");
}

TEST(Answer, IsUndecidedWhereTheBudgetEnded) {
  RunResult run = runWithErrors({0.036});
  run.not_reached = {"frame times of 12 variants in session 'orbit'", "the validation of any variant"};
  const Answer answer = answerWithoutVariant(run, {kNothingSelected, true});
  EXPECT_EQ(answer.kind, ChoiceKind::kUndecided);
  EXPECT_NE(answer.reason.find("frame times of 12 variants in session 'orbit' and 1 more"), std::string::npos) << answer.reason;
  EXPECT_NE(answer.reason.find("larger --budget"), std::string::npos) << answer.reason;
}

// The budget says nothing of an interval that lies on the least gain: with all pairs there it is the original.
TEST(Answer, IsTheOriginalWithTheBestVariantsNumbersWhereAllPairsAreThere) {
  RunResult run = runWithErrors({0.01});
  run.attempts = {failedAttempt("speed-up is 1.02x [0.99, 1.05], which may be more or less than the least gain of 1.05x")};
  const Answer answer = answerWithoutVariant(run, {kNothingSelected});
  EXPECT_EQ(answer.kind, ChoiceKind::kOriginal);
  EXPECT_NE(answer.reason.find("1.02 times as fast (95% interval 0.990 to 1.05)"), std::string::npos) << answer.reason;
  EXPECT_NE(answer.reason.find(run.attempts.back().reason), std::string::npos) << answer.reason;
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected, true}).kind, ChoiceKind::kUndecided);
}

TEST(Answer, NamesTheFastestThatTrainingTimedWhereNoneWentToValidation) {
  RunResult run = runWithErrors({0.01});
  run.candidates[0].configurations[0].points[0].measured_speedup = 0.93;
  run.candidates[0].configurations[0].points[0].speedup_ci95 = RunInterval{0.91, 0.95};
  Selection selection;
  selection.original_reason = "none of 9 configurations is predicted faster";
  const Answer answer = answerWithoutVariant(run, {selection});
  EXPECT_EQ(answer.kind, ChoiceKind::kOriginal);
  EXPECT_NE(answer.reason.find(selection.original_reason), std::string::npos);
  EXPECT_NE(answer.reason.find("0.930 times as fast (95% interval 0.910 to 0.950)"), std::string::npos) << answer.reason;
}

TEST(Answer, IsUndecidedWhereVariantsWereLeftUntried) {
  RunResult run = runWithErrors({0.01});
  run.attempts = {failedAttempt("measured rms 0.03 exceeds 0.02")};
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected, false, false, true}).kind, ChoiceKind::kUndecided);
}

// It differs from the original, which says enough.
TEST(Answer, IsTheOriginalWhereALawRulesTheVariantsOut) {
  RunResult run = runWithErrors({0.01});
  run.attempts = {failedAttempt("law.exact_setting: frame 3, pixel (1, 2)")};
  run.attempts[0].measured_error.reset();
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected}).kind, ChoiceKind::kOriginal);
}

TEST(Answer, IsUndecidedWhereNothingCouldBeMeasured) {
  RunResult run = runWithErrors({0.01});
  run.attempts = {failedAttempt("the variant could not be played: it crashed")};
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected, false, true}).kind, ChoiceKind::kUndecided);
  run.attempts.clear();
  run.candidates[0].status = CandidateStatus::kFailed;
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected}).kind, ChoiceKind::kUndecided);
  run.candidates[0].status = CandidateStatus::kTrained;
  run.original.frame_ms.reset();
  EXPECT_EQ(answerWithoutVariant(run, {kNothingSelected}).kind, ChoiceKind::kUndecided);
}

TEST(Answer, IsTheOriginalWhereNothingIsWorthCaching) {
  const Answer answer = answerWithoutVariant({}, {kNothingSelected, true});
  EXPECT_EQ(answer.kind, ChoiceKind::kOriginal);
  EXPECT_EQ(answer.reason, "no value of the shader is worth caching");
}

}  // namespace
}  // namespace reprise

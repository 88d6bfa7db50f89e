// The reason that is given where the original is the answer.
#include "cli/explain_original.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

RunResult runWithErrors(std::initializer_list<double> errors) {
  RunResult run;
  run.threshold.metric = "rms";
  run.threshold.value = 0.02;
  RunCandidate candidate;
  candidate.id = "light@worst.frag:38";
  candidate.name = "light";
  RunConfiguration configuration;
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

TEST(ExplainOriginal, NamesTheLeastErrorWhereNoneIsSmallEnough) {
  RunResult run = runWithErrors({0.036, 0.045});
  EXPECT_EQ(explainOriginal(run, {}), "no trained value keeps the rms error at 0.02: the least is 0.036, of 'light' refreshed every 2 frames");
  run.not_reached = {"errors of 3 variants"};
  EXPECT_NE(explainOriginal(run, {}).find("the budget did not reach all candidates"), std::string::npos);
}

TEST(ExplainOriginal, BlamesTheBudgetWhereAnErrorIsSmallEnough) {
  RunResult run = runWithErrors({0.004});
  run.not_reached = {"frame times of 12 variants in session 'orbit'"};
  EXPECT_NE(explainOriginal(run, {}).find("a larger --budget may find one"), std::string::npos);
}

TEST(ExplainOriginal, GivesTheSelectionsReasonWhereVariantsWereTimed) {
  Selection selection;
  selection.points.push_back({});
  selection.original_reason = "none of 9 configurations is predicted faster";
  EXPECT_EQ(explainOriginal(runWithErrors({0.004}), selection), selection.original_reason);
}

TEST(ExplainOriginal, TellsTheLastVerdictOfTheValidation) {
  RunResult run = runWithErrors({0.004});
  RunAttempt attempt;
  attempt.reason = "measured error 0.03 exceeds the threshold 0.02";
  run.attempts = {attempt};
  EXPECT_NE(explainOriginal(run, {}).find(attempt.reason), std::string::npos);
}

TEST(ExplainOriginal, SaysThatNothingIsWorthCaching) {
  EXPECT_EQ(explainOriginal({}, {}), "no value of the shader is worth caching under the threshold");
}

}  // namespace
}  // namespace reprise

// `reprise validate --choice`: a committed choice as a gate of error and cost.
#include <gtest/gtest.h>

#include "cli/committed_check.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const fs::path kShaders = fs::path(REPRISE_SOURCE_DIR) / "examples/cmake_project/shaders";

Choice recordedAt(double speedup) {
  Choice choice;
  choice.limits.thresholds = {{"rms", 0.02}};
  choice.device.name = "device";
  choice.measured.speedup = speedup;
  choice.measured.error = 0.01;
  return choice;
}

CommittedMeasures measuredAt(double speedup) {
  CommittedMeasures measured;
  measured.judgement.accepted = true;
  measured.error = 0.012;
  measured.speedup = speedup;
  measured.device = "device";
  return measured;
}

TEST(CommittedCheck, PassesUpToTheTolerance) {
  const Result<CommittedCheck> check = checkCommitted(recordedAt(2), measuredAt(1.7), 0.2);
  ASSERT_TRUE(check.ok()) << formatError(check.error());
  EXPECT_NE(check->sentence.find("0.012"), std::string::npos) << check->sentence;
  EXPECT_EQ(check->note, "");
}

// A cost of 1/1.6 is 25% more than 1/2.
TEST(CommittedCheck, FailsWhereTheCostIsWorseThanThat) {
  EXPECT_TRUE(checkCommitted(recordedAt(2), measuredAt(1.6), 0.2501).ok());
  const Result<CommittedCheck> check = checkCommitted(recordedAt(2), measuredAt(1.6), 0.2499);
  ASSERT_FALSE(check.ok());
  EXPECT_EQ(check.error().code, "validate.cost");
}

TEST(CommittedCheck, FailsWithWhatTheJudgementSays) {
  CommittedMeasures measured = measuredAt(2);
  measured.judgement.accepted = false;
  measured.judgement.code = "judge.error";
  measured.judgement.reason = "too much";
  const Result<CommittedCheck> check = checkCommitted(recordedAt(2), measured, 10);
  ASSERT_FALSE(check.ok());
  EXPECT_EQ(check.error().code, "judge.error");
  EXPECT_EQ(check.error().message, "too much");
}

TEST(CommittedCheck, SaysOfAnotherDeviceThatItIsOne) {
  CommittedMeasures measured = measuredAt(2);
  measured.device = "another";
  EXPECT_EQ(checkCommitted(recordedAt(2), measured, 0.1)->note, "recorded on device, measured on another");
}

// A measurement that gives these one after the other, and counts how often it was asked.
struct Played {
  std::vector<CommittedMeasures> measures;
  std::vector<int> timings = {};

  MeasureCommitted measure() {
    return [this](int timing) -> Result<CommittedMeasures> {
      timings.push_back(timing);
      return measures.at(timings.size() - 1);
    };
  }
};

CommittedMeasures failingBy(const std::string& code) {
  CommittedMeasures measured = measuredAt(1);
  measured.judgement = {false, code, "it failed"};
  return measured;
}

TEST(CommittedCheck, TimesAgainWhatFailedByItsTimes) {
  for (const char* code : {"judge.not_faster", "judge.straddles", "judge.wall_not_faster", "judge.wall_straddles"}) {
    Played played{{failingBy(code), failingBy("judge.straddles"), measuredAt(2)}};
    const Result<CommittedCheck> check = checkCommittedAgain(recordedAt(2), played.measure(), 0.2);
    ASSERT_TRUE(check.ok()) << code << " " << formatError(check.error());
    EXPECT_EQ(played.timings, (std::vector<int>{1, 2, 3}));
    EXPECT_NE(check->sentence.find("timed 3 times"), std::string::npos) << check->sentence;
  }
}

TEST(CommittedCheck, TimesAgainWhatCostTooMuch) {
  Played played{{measuredAt(1.2), measuredAt(1.9)}};
  const Result<CommittedCheck> check = checkCommittedAgain(recordedAt(2), played.measure(), 0.2);
  ASSERT_TRUE(check.ok()) << formatError(check.error());
  EXPECT_NE(check->sentence.find("timed 2 times"), std::string::npos) << check->sentence;
}

TEST(CommittedCheck, FailsAfterThreeTimings) {
  Played played{{measuredAt(1.2), measuredAt(1.3), measuredAt(1.25), measuredAt(2)}};
  const Result<CommittedCheck> check = checkCommittedAgain(recordedAt(2), played.measure(), 0.2);
  ASSERT_FALSE(check.ok());
  EXPECT_EQ(played.timings.size(), 3u);
  EXPECT_EQ(check.error().code, "validate.cost");
  EXPECT_NE(check.error().message.find("timed 3 times"), std::string::npos) << check.error().message;
}

TEST(CommittedCheck, RepeatsNoErrorAndNothingThatHolds) {
  for (const char* code : {"judge.error", "judge.nonfinite", "judge.unmeasured", "law.exact_setting"}) {
    Played played{{failingBy(code), measuredAt(2)}};
    const Result<CommittedCheck> check = checkCommittedAgain(recordedAt(2), played.measure(), 0.2);
    ASSERT_FALSE(check.ok());
    EXPECT_EQ(played.timings.size(), 1u) << code;
    EXPECT_EQ(check.error().message, "it failed");
  }
  Played played{{measuredAt(2)}};
  const Result<CommittedCheck> check = checkCommittedAgain(recordedAt(2), played.measure(), 0.2);
  ASSERT_TRUE(check.ok());
  EXPECT_EQ(played.timings.size(), 1u);
  EXPECT_NE(check->sentence.find("timed once"), std::string::npos) << check->sentence;
}

TEST(CommittedCheck, PassesOnWhatMeasuringSays) {
  const MeasureCommitted interrupted = [](int) -> Result<CommittedMeasures> { return Error{ErrorKind::kInterrupted, "interrupted", "", {}}; };
  EXPECT_EQ(checkCommittedAgain(recordedAt(2), interrupted, 0.2).error().code, "interrupted");
}

class ValidateChoice : public testing::Test {
 protected:
  void SetUp() override { fs::copy(kShaders, shaders()); }

  fs::path shaders() const { return folder_ / "shaders"; }

  CommandOutcome validate() const { return runCommand({REPRISE_EXECUTABLE, "validate", "--choice", shaders() / "granite.choice.json", "-o", folder_ / "run"}); }

  void replace(const std::string& from, const std::string& to) const {
    const fs::path file = shaders() / "granite.choice.json";
    std::string text = textOf(file);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    writeText(file, text.replace(text.find(from), from.size(), to));
  }

  TemporaryFolder folder_;
};

TEST_F(ValidateChoice, FailsWhereTheErrorExceedsTheThreshold) {
  replace("\"value\": 0.03", "\"value\": 0.0001");
  const CommandOutcome outcome = validate();
  EXPECT_EQ(outcome.status, 1) << outcome.all();
  EXPECT_NE(outcome.errors.find("0.0001"), std::string::npos) << outcome.errors;
}

TEST_F(ValidateChoice, FailsWhereTheRecordedGainIsOutOfReach) {
  replace("\"speedup\": 3.4195241771225846", "\"speedup\": 1000000.0");
  const CommandOutcome outcome = validate();
  EXPECT_EQ(outcome.status, 1) << outcome.all();
  EXPECT_NE(outcome.errors.find("error:"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("timed 3 times"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace reprise

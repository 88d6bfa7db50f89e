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
}

}  // namespace
}  // namespace reprise

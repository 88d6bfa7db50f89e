// What the machine or the user does to a run: no device, a full disk, a second run on the same output.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

void hideDevices(CommandSpec& spec) {
  for (const char* name : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
    spec.environment.emplace_back(name, "/nonexistent.json");
}

TEST(NoDevice, OptimizeSaysSoAndLeavesNothing) {
  const SmallScenario scenario;
  CommandSpec spec = optimizeSmall(scenario);
  hideDevices(spec);
  expectRefusal(runCommand(spec), kExitMachineLacks, {"Vulkan"});
  EXPECT_EQ(leftovers(scenario.output()), "");
}

TEST(NoDevice, DevicesSaysSo) {
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "devices"};
  hideDevices(spec);
  expectRefusal(runCommand(spec), kExitMachineLacks, {"Vulkan"});
}

TEST(NoDevice, AnalyzeNeedsNone) {
  const SmallScenario scenario;
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "analyze", scenario.fragment()};
  hideDevices(spec);
  EXPECT_EQ(runCommand(spec).status, kExitDone);
}

TEST(OutputFolder, IsAFileThatStaysAsItWas) {
  const SmallScenario scenario;
  writeText(scenario.output(), "somebody's notes");
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, {scenario.output().filename(), "file"});
  EXPECT_EQ(textOf(scenario.output()), "somebody's notes");
}

// Files that cannot grow: what a full disk does to each write, without the rights that mounting one needs.
TEST(FullDisk, FilesThatCannotGrowEndTheRunWithoutAResult) {
  const SmallScenario scenario;
  CommandSpec spec = optimizeSmall(scenario, {"--budget", "20s"});
  spec.file_size_limit_bytes = 1024;
  expectRefusal(runCommand(spec), kExitMachineLacks, {"error: "});
  EXPECT_EQ(leftovers(scenario.output()), "");
}

// Full at once, and full in the middle of the measurements.
class SmallDisk : public testing::TestWithParam<std::string> {};

TEST_P(SmallDisk, EndsTheRunWithoutAResult) {
  const SmallScenario scenario;
  fs::create_directories(scenario.output());
  const std::string mount =
      "mount -t tmpfs -o size=" + GetParam() + " reprise_test '" + scenario.output().string() + "'";
  if (runCommand({"unshare", "--map-root-user", "--mount", "sh", "-c", mount}).status != 0) {
    GTEST_SKIP() << "this machine does not let a test mount a file system of its own";
  }
  CommandSpec spec;
  std::string run;
  for (const std::string& word : optimizeSmall(scenario, {"--budget", "20s"}).words) run += " '" + word + "'";
  // The file system goes with the shell, so what is left on it is listed before.
  spec.words = {
      "unshare",
      "--map-root-user",
      "--mount",
      "sh",
      "-c",
      mount + " && { " + run + "; status=$?; find '" + scenario.output().string() + "'; exit $status; }"};
  const CommandOutcome outcome = runCommand(spec);
  expectRefusal(outcome, kExitMachineLacks, {"error: "});
  for (const std::string name : {"/result.json", "/report.html", "/out/package", ".tmp"}) {
    EXPECT_EQ(outcome.output.find(name), std::string::npos) << outcome.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SmallDisk, testing::Values("64k", "400k"));

TEST(TwoRuns, OnOneOutputLeaveItWhole) {
  const SmallScenario scenario;
  Command first(optimizeSmall(scenario)), second(optimizeSmall(scenario));
  const CommandOutcome outcomes[] = {first.wait(), second.wait()};
  int finished = 0;
  for (const CommandOutcome& outcome : outcomes) {
    finished += outcome.status == kExitDone;
    // One that does not wait for the other refuses, and says whom it met.
    if (outcome.status != kExitDone) {
      EXPECT_NE(outcome.errors.find("another"), std::string::npos) << outcome.errors;
    }
  }
  EXPECT_GE(finished, 1) << outcomes[0].all() << outcomes[1].all();
  const CommandOutcome report = runCommand({REPRISE_EXECUTABLE, "report", scenario.output()});
  EXPECT_EQ(report.status, kExitDone) << report.all();
}

TEST(ShaderThatGivesNaN, IsReportedAndNotAveragedAway) {
  const SmallScenario scenario;
  scenario.replace(scenario.toml(), "rgba8_unorm", "rgba16_sfloat");  // which can hold one
  // Negative over half of the ball: its square root is no number there.
  scenario.replace(scenario.fragment(), "float pattern = 0.5",
                   "float pattern = sqrt(object_position.x) + 0.5");
  const CommandOutcome outcome = runCommand(optimizeSmall(scenario, {"--budget", "20s"}));
  EXPECT_TRUE(outcome.status == kExitDone || outcome.status == kExitBadInput || outcome.status == kExitUndecided)
      << outcome.status << outcome.all();
  EXPECT_NE((outcome.all() + textOf(scenario.output() / "result.json")).find("not finite"), std::string::npos)
      << outcome.all();
}

}  // namespace
}  // namespace reprise

// Law 9: killed at any moment, a run is taken up again and ends with the errors that an unbroken run
// measures.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "cli/report/result.h"
#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

// Measured training errors by variant and period. Times differ from run to run, and with them what is
// measured beyond this.
std::map<std::string, double> measuredErrors(const fs::path& output) {
  std::map<std::string, double> errors;
  const Result<RunResult> result = resultFromJson(textOf(output / "result.json"));
  if (!result.ok()) {
    ADD_FAILURE() << formatError(result.error());
    return errors;
  }
  for (const RunCandidate& candidate : result->candidates) {
    for (const RunConfiguration& way : candidate.configurations) {
      for (const RunPoint& point : way.points) {
        if (!point.measured_error) continue;
        errors[candidate.id + " " + way.strategy + " " + way.pattern + " " +
               std::to_string(way.block_pixels) + " " + way.filter + " " + way.encoding + " " +
               std::to_string(point.period_frames)] = *point.measured_error;
      }
    }
  }
  return errors;
}

// The first child process of a process; nullopt if it has none.
std::optional<pid_t> childOf(pid_t process) {
  const std::string id = std::to_string(process);
  std::ifstream children("/proc/" + id + "/task/" + id + "/children");
  pid_t child = 0;
  if (children >> child) return child;
  return std::nullopt;
}

TEST(Resume, KilledRunEndsWithTheErrorsOfAnUnbrokenOne) {
  const SmallScenario unbroken, broken;
  const CommandOutcome whole = runCommand(optimizeSmall(unbroken));
  ASSERT_EQ(whole.status, kExitDone) << whole.all();

  {
    Command run(optimizeSmall(broken));
    ASSERT_TRUE(waitForMeasurements(run, broken.output())) << run.wait().all();
    run.signalGroup(SIGKILL);
    EXPECT_EQ(run.wait().status, 128 + SIGKILL);
  }
  EXPECT_FALSE(fs::exists(broken.output() / "result.json"));

  const CommandOutcome resumed = runCommand(optimizeSmall(broken));
  ASSERT_EQ(resumed.status, kExitDone) << resumed.all();
  const std::map<std::string, double> expected = measuredErrors(unbroken.output());
  const std::map<std::string, double> measured = measuredErrors(broken.output());
  std::size_t compared = 0;
  for (const auto& [variant, error] : measured) {
    const auto found = expected.find(variant);
    if (found == expected.end()) continue;
    EXPECT_EQ(error, found->second) << variant;
    ++compared;
  }
  EXPECT_GT(compared, 0u);
}

TEST(Resume, KilledWorkerIsRecordedAndTheRunGoesOn) {
  const SmallScenario scenario;
  Command run(optimizeSmall(scenario));
  ASSERT_TRUE(waitForMeasurements(run, scenario.output())) << run.wait().all();
  std::optional<pid_t> worker;
  while (run.running() && !worker) worker = childOf(run.process());
  ASSERT_TRUE(worker.has_value()) << "the run has no worker process: " << run.wait().all();
  kill(*worker, SIGKILL);

  const CommandOutcome outcome = run.wait();
  // Undecided where nobody else was left to measure.
  EXPECT_TRUE(outcome.status == kExitDone || outcome.status == kExitUndecided) << outcome.status << outcome.all();
  EXPECT_TRUE(fs::exists(scenario.output() / "result.json"));
}

}  // namespace
}  // namespace reprise

// Ctrl-C, a service that is stopped, a terminal that is closed: the run ends by itself, and its workers with it.
#include <gtest/gtest.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::vector<pid_t> childrenOf(pid_t process) {
  std::vector<pid_t> children;
  std::error_code gone;
  for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(process) + "/task", gone)) {
    std::ifstream stream(thread.path() / "children");
    for (pid_t child = 0; stream >> child;) children.push_back(child);
  }
  return children;
}

bool endsSoon(pid_t process) {
  for (int i = 0; i < 500; ++i) {
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    if (!(stat >> id >> name >> state) || state == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, RunEndsWithItsWorkerAndCanBeTakenUpAgain) {
  const SmallScenario scenario;
  Command run(optimizeSmall(scenario));
  ASSERT_TRUE(waitForMeasurements(run, scenario.output())) << run.wait().all();
  std::vector<pid_t> workers;
  while (run.running() && workers.empty()) workers = childrenOf(run.process());
  run.signal(GetParam());
  const CommandOutcome interrupted = run.wait();
  EXPECT_EQ(interrupted.status, kExitInterrupted) << interrupted.all();
  EXPECT_NE(interrupted.errors.find("run.interrupted"), std::string::npos) << interrupted.errors;
  EXPECT_EQ(leftovers(scenario.output()), "");
  for (const pid_t worker : workers) EXPECT_TRUE(endsSoon(worker)) << worker;

  const CommandOutcome resumed = runCommand(optimizeSmall(scenario));
  EXPECT_EQ(resumed.status, kExitDone) << resumed.all();
  EXPECT_TRUE(fs::exists(scenario.output() / "result.json"));
}

TEST_P(Interrupted, CheckEndsWithItsWorkers) {
  const SmallScenario scenario;
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "check", scenario.fragment(), "--candidates", "50"};
  Command run(spec);
  std::vector<pid_t> workers, references;
  while (run.running() && references.empty()) {
    workers = childrenOf(run.process());
    for (const pid_t worker : workers) references = childrenOf(worker);
  }
  ASSERT_FALSE(references.empty()) << run.wait().all();
  run.signal(GetParam());
  const CommandOutcome interrupted = run.wait();
  EXPECT_EQ(interrupted.status, kExitInterrupted) << interrupted.all();
  for (const pid_t process : workers) EXPECT_TRUE(endsSoon(process)) << process;
  for (const pid_t process : references) EXPECT_TRUE(endsSoon(process)) << process;
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP), [](const auto& each) { return std::string(sigabbrev_np(each.param)); });

// As from a terminal, or from `timeout`, which signals the group.
TEST(InterruptedGroup, LeavesTheMeaningToTheSupervisor) {
  const SmallScenario scenario;
  Command run(optimizeSmall(scenario));
  ASSERT_TRUE(waitForMeasurements(run, scenario.output())) << run.wait().all();
  run.signalGroup(SIGTERM);
  EXPECT_EQ(run.wait().status, kExitInterrupted);
  EXPECT_EQ(leftovers(scenario.output()), "");
}

TEST(InterruptedAnalysis, EndsAtOnce) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  CommandSpec spec;
  spec.words = {"sh", "-c", std::string("exec ") + REPRISE_EXECUTABLE + " analyze - <> " + (folder / "pipe").string()};  // waits for text
  spec.time_limit = std::chrono::seconds(20);
  Command run(spec);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_TRUE(run.running());
  run.signal(SIGTERM);
  const CommandOutcome outcome = run.wait();
  EXPECT_FALSE(outcome.timed_out);
  EXPECT_EQ(outcome.status, 128 + SIGTERM);
}

}  // namespace
}  // namespace reprise

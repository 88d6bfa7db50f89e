// What --budget counts, and what is said where it ends early.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/device_lock.h"
#include "cli/measured_device.h"
#include "cli/pipeline.h"
#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value) : name_(name) {
    if (const char* set = std::getenv(name)) before_ = set;
    ::setenv(name, value.c_str(), 1);
  }
  ~ScopedVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Budget, ThatEndsBeforeAnyMeasurementLeavesTheAnswerUndecided) {
  const SmallScenario scenario;
  ASSERT_EQ(runCommand(optimizeSmall(scenario, {"--budget", "0.001s"})).status, kExitUndecided);
  const Result<RunResult> result = resultFromJson(textOf(scenario.output() / "result.json"));
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_EQ(result->choice.kind, ChoiceKind::kUndecided);
  EXPECT_FALSE(fs::exists(scenario.output() / "choice.json"));
  EXPECT_TRUE(fs::exists(scenario.output() / "package" / "manifest.json")) << "it holds the original";
  EXPECT_FALSE(result->not_reached.empty());
  EXPECT_NE(result->choice.reason.find("budget"), std::string::npos) << result->choice.reason;
}

// Another run holds the device for an hour, by the clock of this one.
TEST(Budget, IsNotSpentByWaitingForTheDevice) {
  const SmallScenario scenario;
  scenario.replace(scenario.toml(), "periods = [1, 2, 4]", "periods = [1, 2]");
  // A lock of this test alone, so that no run beside it is waited for.
  const fs::path folder = scenario.file("locks");
  fs::create_directory(folder);
  const ScopedVariable temporary("TMPDIR", folder.string());
  const Result<MeasuredDevice> device = openMeasuredDevice("");
  ASSERT_TRUE(device.ok()) << formatError(device.error());
  std::optional<DeviceLock> other;
  {
    Result<DeviceLock> taken = DeviceLock::take(device->summary.name, "another run", {});
    ASSERT_TRUE(taken.ok());
    other.emplace(std::move(*taken));
  }
  double now_s = 0;
  Progress progress(ProgressStyle::kQuiet, [&] { return now_s; });
  OptimizeArguments arguments;
  arguments.scenario = scenario.toml().string();
  arguments.demand = demandOf({.max_error = 1e-9}).value();  // nothing keeps it, so the run is short
  arguments.budget_s = 600;
  arguments.output = scenario.output().string();
  arguments.worker_path = REPRISE_EXECUTABLE;
  arguments.interrupted = [&] {
    if (other) now_s = 3600;
    other.reset();
    return false;
  };
  const Result<RunResult> result = optimize(arguments, progress);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_FALSE(other.has_value()) << "it did not wait";
  EXPECT_TRUE(result->original.frame_ms.has_value());
  EXPECT_TRUE(std::none_of(result->not_reached.begin(), result->not_reached.end(),
                           [](const std::string& what) { return what.find("in session") != std::string::npos; }))
      << result->not_reached.front();
  const auto waited = std::find_if(result->seconds.begin(), result->seconds.end(), [](const auto& stage) { return stage.name == "wait for the device"; });
  ASSERT_NE(waited, result->seconds.end());
  EXPECT_EQ(waited->seconds, 3600);
}

}  // namespace
}  // namespace reprise

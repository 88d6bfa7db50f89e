// What a run times: hits are told from misses by two hit rates, so each variant is timed at two periods whose hits were counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "cli/report/result.h"
#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

std::size_t longestLine(const std::string& text) {
  std::size_t longest = 0, columns = 0;
  for (const char letter : text) {
    if (letter == '\n') columns = 0;
    else if ((letter & 0xC0) != 0x80) longest = std::max(longest, ++columns);
  }
  return longest;
}

// Every error is allowed, so that all candidates are timed.
Result<RunResult> runWithPeriods(const std::string& periods, const std::function<void(const SmallScenario&)>& change = {}) {
  const SmallScenario scenario;
  if (change) change(scenario);
  scenario.replace(scenario.toml(), "periods = [1, 2, 4]", "periods = " + periods);
  CommandSpec command = optimizeSmall(scenario);
  const auto threshold = std::find(command.words.begin(), command.words.end(), "--max-error");
  if (threshold != command.words.end()) *(threshold + 1) = "1";
  const CommandOutcome outcome = runCommand(command);
  EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
  EXPECT_LE(longestLine(outcome.output), 80u) << outcome.output;
  EXPECT_LE(longestLine(outcome.errors), 80u) << outcome.errors;
  return resultFromJson(textOf(scenario.output() / "result.json"));
}

bool isTimed(const RunConfiguration& configuration, std::uint32_t period_frames) {
  return std::any_of(configuration.points.begin(), configuration.points.end(),
                     [&](const RunPoint& point) { return point.period_frames == period_frames && point.measured_frame_ms; });
}

std::vector<RunConfiguration> baseConfigurations(const RunResult& result) {
  std::vector<RunConfiguration> base;
  for (const RunCandidate& candidate : result.candidates)
    for (const RunConfiguration& one : candidate.configurations)
      if (one.pattern == "interleaved" && one.filter == "bilinear" && one.encoding == "rgba16f" && !one.points.empty()) base.push_back(one);
  return base;
}

// Why a strategy is refused; empty where it is not.
std::string refusalOf(const RunResult& result, const std::string& strategy) {
  for (const std::string& text : result.strategies_refused)
    if (text.starts_with(strategy + ": ")) return text;
  return "";
}

// Hits have errors: a frame of misses has none.
TEST(Training, TakesAFarPlaneAtInfinity) {
  const Result<RunResult> result = runWithPeriods("[1, 4]", [](const SmallScenario& scenario) {
    scenario.replace(scenario.toml(), "radians_per_frame = 0.02 } }", "radians_per_frame = 0.02 }, far = inf }");
    scenario.replace(scenario.toml(), "radians_per_frame = 0.03 } }", "radians_per_frame = 0.03 }, far = inf }");
  });
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  bool hits = false;
  for (const RunConfiguration& one : baseConfigurations(*result))
    for (const RunPoint& point : one.points) hits |= point.measured_error && *point.measured_error > 0;
  EXPECT_TRUE(hits);
  for (const std::string& warning : result->warnings) EXPECT_EQ(warning.find("not finite"), std::string::npos) << warning;
}

TEST(Training, TimesTheShortestAndTheLongestAcceptablePeriod) {
  const Result<RunResult> result = runWithPeriods("[1, 4, \"never\"]");
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  std::size_t timed = 0;
  for (const RunConfiguration& configuration : baseConfigurations(*result)) {
    if (!isTimed(configuration, 4) && !isTimed(configuration, 0)) continue;
    ++timed;
    EXPECT_TRUE(isTimed(configuration, 4)) << configuration.strategy;
    EXPECT_TRUE(isTimed(configuration, 0)) << configuration.strategy;
  }
  EXPECT_GT(timed, 0u);
}

TEST(Training, SaysWhichStrategiesAreRefused) {
  const Result<RunResult> result = runWithPeriods("[1, 2]");
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_NE(refusalOf(*result, "two_pass_stencil"), "");
  EXPECT_NE(refusalOf(*result, "two_pass_objects").find("there is only one object"), std::string::npos) << refusalOf(*result, "two_pass_objects");
}

// A second ball, and cameras that stand still or turn.
Result<RunResult> runOfTwoBalls(bool still) {
  return runWithPeriods("[1, 2]", [&](const SmallScenario& scenario) {
    scenario.replace(scenario.toml(), "cull = \"none\"", "cull = \"back\"");
    scenario.replace(scenario.toml(), "[uniforms]", "[[object]]\nname = \"second\"\nmesh = { kind = \"sphere\", radius = 0.7 }\nmotion = { translate = [0, 0, 1.8] }\n[uniforms]");
    if (!still) return;
    scenario.replace(scenario.toml(), "translate = [0, 0, 1.8]", "translate = [2.5, 0, 0]");
    scenario.replace(scenario.toml(), "{ orbit = { radius = 3.0, radians_per_frame = 0.02 } }", "{ eye = [1, 0, 6], target = [1, 0, 0] }");
  });
}

std::size_t configurationsOf(const RunResult& result, const std::string& strategy) {
  std::size_t count = 0;
  for (const RunConfiguration& one : baseConfigurations(result)) count += one.strategy == strategy ? 1 : 0;
  return count;
}

TEST(Training, TimesLeavingOutObjectsWhereSomeHaveNoMisses) {
  const Result<RunResult> still = runOfTwoBalls(true);
  ASSERT_TRUE(still.ok()) << formatError(still.error());
  EXPECT_EQ(refusalOf(*still, "two_pass_objects"), "");
  EXPECT_GT(configurationsOf(*still, "two_pass_objects"), 0u);
  const Result<RunResult> turning = runOfTwoBalls(false);
  ASSERT_TRUE(turning.ok()) << formatError(turning.error());
  EXPECT_NE(refusalOf(*turning, "two_pass_objects").find("% of the objects of a frame have some"), std::string::npos) << refusalOf(*turning, "two_pass_objects");
  EXPECT_EQ(configurationsOf(*turning, "two_pass_objects"), 0u);
}

TEST(Training, TimesVariantsThatAreNeverRefreshedAlone) {
  const Result<RunResult> result = runWithPeriods("[1, \"never\"]");
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  const std::vector<RunConfiguration> base = baseConfigurations(*result);
  EXPECT_TRUE(std::any_of(base.begin(), base.end(), [](const RunConfiguration& one) { return isTimed(one, 0); }));
}

}  // namespace
}  // namespace reprise

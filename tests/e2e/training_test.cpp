// What a run times: hits are told from misses by two hit rates, so each variant is timed at two periods whose hits were counted.
#include <gtest/gtest.h>

#include <algorithm>

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
Result<RunResult> runWithPeriods(const std::string& periods) {
  const SmallScenario scenario;
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
  const auto is_stencil = [](const std::string& text) { return text.starts_with("two_pass_stencil: "); };
  EXPECT_EQ(std::count_if(result->strategies_refused.begin(), result->strategies_refused.end(), is_stencil), 1);
}

TEST(Training, TimesVariantsThatAreNeverRefreshedAlone) {
  const Result<RunResult> result = runWithPeriods("[1, \"never\"]");
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  const std::vector<RunConfiguration> base = baseConfigurations(*result);
  EXPECT_TRUE(std::any_of(base.begin(), base.end(), [](const RunConfiguration& one) { return isTimed(one, 0); }));
}

}  // namespace
}  // namespace reprise

// Which periods sessions are long enough for.
#include "cli/studied_periods.h"

#include <gtest/gtest.h>

#include "profiler/scenario/scenario.h"

namespace reprise {
namespace {

Scenario scenarioOf(int training_frames, int validation_frames) {
  Scenario scenario;
  scenario.frames = 48;
  scenario.periods = {1, 2, 16, 32, 64};
  scenario.sessions = {{}, {}};
  scenario.sessions[0].name = "orbit";
  scenario.sessions[0].role = SessionRole::kTraining;
  scenario.sessions[0].frames = training_frames;
  scenario.sessions[1].name = "walk";
  scenario.sessions[1].role = SessionRole::kValidation;
  scenario.sessions[1].frames = validation_frames;
  return scenario;
}

TEST(Periods, ThatTrainingIsTooShortForAreLeftToTheModels) {
  const Scenario scenario = scenarioOf(72, 152);
  EXPECT_EQ(studiedPeriods(scenario), (std::vector<std::uint32_t>{2, 16, 32}));
  EXPECT_EQ(selectablePeriods(scenario), (std::vector<std::uint32_t>{2, 16, 32, 64}));
  const std::vector<std::string> warnings = shortSessionWarnings(scenario);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "session 'orbit' has 72 frames; period 64 needs more than 128, so the errors of these are predicted, not measured: 64");
}

TEST(Periods, ThatValidationIsTooShortForAreNotTried) {
  const Scenario scenario = scenarioOf(152, 40);
  EXPECT_EQ(selectablePeriods(scenario), (std::vector<std::uint32_t>{2, 16}));
  const std::vector<std::string> warnings = shortSessionWarnings(scenario);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "session 'walk' has 40 frames; period 32 needs more than 64, so these cannot be validated and are not tried: 32, 64");
}

TEST(Periods, OfLongSessionsNeedNoWord) { EXPECT_TRUE(shortSessionWarnings(scenarioOf(152, 129)).empty()); }

}  // namespace
}  // namespace reprise

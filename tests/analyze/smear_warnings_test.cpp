// What caching will smear, told without measuring.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/smear_warnings.h"
#include "cli/subject.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

std::vector<std::string> warningsOf(const SmallScenario& scenario) {
  const Result<Subject> subject = readSubject(scenario.toml());
  REPRISE_CHECK(subject.ok(), subject.ok() ? "" : formatError(subject.error()));
  std::vector<std::string> ids;
  for (const Candidate& candidate : subject->candidates)
    if (candidate.kept()) ids.push_back(candidate.id);
  return smearWarnings(*subject, ids);
}

bool anySays(const std::vector<std::string>& warnings, const std::string& what) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) { return warning.find(what) != std::string::npos; });
}

TEST(SmearWarnings, AreNoneWhereOnlyTheCameraMoves) { EXPECT_TRUE(warningsOf(SmallScenario()).empty()); }

TEST(SmearWarnings, NameTheUniformThatThePayloadChangesWith) {
  SmallScenario scenario;
  scenario.replace(scenario.toml(), "\"Frame.gain\" = { value = 0.75 }", "\"Frame.gain\" = \"time\"");
  const std::vector<std::string> warnings = warningsOf(scenario);
  EXPECT_TRUE(anySays(warnings, "changes over time with Frame.gain"));
  EXPECT_FALSE(anySays(warnings, "pattern")) << "which does not depend on it";
}

TEST(SmearWarnings, AreNoneOfAUniformThatAPathKeepsStill) {
  SmallScenario scenario;
  scenario.replace(scenario.toml(), "\"Frame.gain\" = { value = 0.75 }", "\"Frame.gain\" = 0.5");
  EXPECT_TRUE(warningsOf(scenario).empty());
}

TEST(SmearWarnings, SayWhereTextureCoordinatesScroll) {
  SmallScenario scenario;
  scenario.replace(scenario.toml(), "\"Frame.gain\" = { value = 0.75 }", "\"Frame.gain\" = \"time\"");
  scenario.replace(scenario.fragment(), "texture(grain, object_position.xy).r", "exp(sin(exp(sin(texture(grain, object_position.xy + frame.gain).r))))");
  scenario.replace(scenario.fragment(), "float waves = 0.0;", "float waves = sin(exp(sin(texture(grain, object_position.xy + frame.gain).r)));");
  const int line = SmallScenario::lineOf(scenario.fragment(), "float waves");
  EXPECT_TRUE(anySays(warningsOf(scenario), "texture coordinates at small.frag:" + std::to_string(line)));
}

}  // namespace
}  // namespace reprise

// Motion that is not there: who is refused, who is suspected, and who is neither.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/motion.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const std::string kTrainCamera = "{ orbit = { radius = 3.0, radians_per_frame = 0.02 } }";
const std::string kCheckCamera = "{ orbit = { radius = 2.5, height = 0.5, radians_per_frame = 0.03 } }";
const std::string kStillCamera = "{ eye = [0, 0, 3], target = [0, 0, 0] }";

void standStill(const SmallScenario& scenario) {
  scenario.replace(scenario.toml(), kTrainCamera, kStillCamera);
  scenario.replace(scenario.toml(), kCheckCamera, kStillCamera);
}

void flattenPosition(const SmallScenario& scenario) {
  scenario.replace(scenario.vertex(), "gl_Position = frame.view_projection * world", "gl_Position = vec4(position.xy, 0.5, 1.0)");
}

Subject subjectOf(const SmallScenario& scenario) {
  Result<Subject> subject = readSubject(scenario.toml());
  REPRISE_CHECK(subject.ok(), subject.ok() ? "" : formatError(subject.error()));
  return std::move(*subject);
}

bool still(const SmallScenario& scenario) {
  const Subject subject = subjectOf(scenario);
  return standsStill(subject.scenario, subject.program.interface, positionInputs(subject.program.vertex).value());
}

TEST(Motion, IsMissingWhereThePositionReadsNothing) {
  const SmallScenario scenario;
  flattenPosition(scenario);
  const Result<Subject> subject = readSubject(scenario.toml());
  ASSERT_FALSE(subject.ok());
  EXPECT_EQ(subject.error().code, "motion.none");
  EXPECT_EQ(subject.error().kind, ErrorKind::kRefused);
  EXPECT_EQ(subject.error().place.file, scenario.vertex().string());
  EXPECT_NE(subject.error().message.find("motion = \"none\""), std::string::npos) << subject.error().message;
  scenario.replace(scenario.toml(), "name = \"small\"", "name = \"small\"\nmotion = \"none\"");
  const Result<Subject> said = readSubject(scenario.toml());
  EXPECT_TRUE(said.ok()) << formatError(said.error());
}

class ShippedScenarios : public testing::TestWithParam<std::string> {};

std::vector<std::string> shippedScenarios() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPRISE_SOURCE_DIR) / "shaders"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  return paths;
}

TEST_P(ShippedScenarios, HaveMotion) {
  const Result<Subject> subject = readSubjectUnranked(GetParam());
  ASSERT_TRUE(subject.ok()) << formatError(subject.error());
  const Result<void> taken = expectMotion(*subject);
  EXPECT_TRUE(taken.ok()) << formatError(taken.error());
  EXPECT_FALSE(standsStill(subject->scenario, subject->program.interface, positionInputs(subject->program.vertex).value()));
}

INSTANTIATE_TEST_SUITE_P(Motion, ShippedScenarios, testing::ValuesIn(shippedScenarios()),
                         [](const auto& each) { return fs::path(each.param).stem().string(); });

TEST(StandsStill, IsTrueWhereCamerasAndObjectsDo) {
  const SmallScenario scenario;
  EXPECT_FALSE(still(scenario));
  scenario.replace(scenario.toml(), kTrainCamera, kStillCamera);
  EXPECT_FALSE(still(scenario)) << "the other session's camera moves";
  scenario.replace(scenario.toml(), kCheckCamera, kStillCamera);
  EXPECT_TRUE(still(scenario));
  scenario.replace(scenario.toml(), "segments_v = 12 }", "segments_v = 12 }\nmotion = { spin_rad_per_frame = 0.01 }");
  EXPECT_FALSE(still(scenario)) << "the object turns";
}

TEST(StandsStill, LooksOnlyAtWhatThePositionReads) {
  const SmallScenario scenario;
  standStill(scenario);
  scenario.replace(scenario.toml(), "\"Frame.gain\" = { value = 0.75 }", "\"Frame.gain\" = \"time\"");
  EXPECT_TRUE(still(scenario)) << "gain lies in the block that holds the matrix";
  scenario.replace(scenario.vertex(), "vec4(position, 1.0)", "vec4(position * frame.gain, 1.0)");
  EXPECT_FALSE(still(scenario));
}

TEST(EncodingStep, IsThatOfTheFormat) {
  EXPECT_EQ(encodingStep(Encoding::kRgba8, false, -1, 254), 1);
  EXPECT_EQ(encodingStep(Encoding::kRgba16, false, 0, 65535), 1);
  EXPECT_EQ(encodingStep(Encoding::kRgba16f, false, -1024, 4), 1);
  EXPECT_EQ(encodingStep(Encoding::kRgba32f, false, 0, 8388608), 1);
  EXPECT_EQ(encodingStep(Encoding::kRgba32f, true, 0, 8388608), 0);
}

// As the probe would have left it: every kept candidate in [0, 1], and its first channel changed by so much.
Training trained(const Subject& subject, float change) {
  Training training;
  for (std::size_t at = 0; at < subject.candidates.size(); ++at) {
    if (!subject.candidates[at].kept()) continue;
    training.ranges[at].payload_max.fill(1);
    training.changes[at][0] = change;
  }
  return training;
}

TEST(SuspectMotion, NeedsAStillSceneAndAPayloadThatChanges) {
  const SmallScenario scenario;
  const Subject moving = subjectOf(scenario);
  EXPECT_EQ(suspectMotion(moving, trained(moving, 0.5f), ""), std::nullopt);
  standStill(scenario);
  const Subject at_rest = subjectOf(scenario);
  EXPECT_EQ(suspectMotion(at_rest, trained(at_rest, 0), ""), std::nullopt);
  EXPECT_EQ(suspectMotion(at_rest, trained(at_rest, 0.0009f), ""), std::nullopt) << "less than a step of a half float at 1";
  const std::optional<std::string> warning = suspectMotion(at_rest, trained(at_rest, 0.25f), "");
  ASSERT_TRUE(warning.has_value());
  EXPECT_TRUE(warning->starts_with("motion.suspect: ")) << *warning;
  for (const char* words : {"by up to 0.25", "is wrong", "may be right"}) EXPECT_NE(warning->find(words), std::string::npos) << *warning;
}

TEST(SuspectMotion, AsksAfterThePayloadThatWasChosen) {
  const SmallScenario scenario;
  standStill(scenario);
  const Subject subject = subjectOf(scenario);
  Training training = trained(subject, 0);
  ASSERT_GE(training.changes.size(), 2u);
  const auto last = std::prev(training.changes.end());
  last->second[0] = 0.25f;
  const Candidate& changing = subject.candidates[last->first];
  EXPECT_TRUE(suspectMotion(subject, training, changing.id).has_value());
  EXPECT_TRUE(suspectMotion(subject, training, "").has_value());
  EXPECT_EQ(suspectMotion(subject, training, subject.candidates[training.changes.begin()->first].id), std::nullopt);
}

}  // namespace
}  // namespace reprise

// Stereo scenarios: what the file may say, and what the two eyes of a moment see.
#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "profiler/scenario/read_scenario.h"
#include "profiler/scene/frame_state.h"
#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

constexpr float kEyeDistance = 0.06f;

std::string stereoText(const std::string& stereo, const std::string& periods = "") {
  return changed(validScenario(), "periods = [1, 2, \"never\"]\n", periods + "stereo = " + stereo + "\n");
}

std::string refusal(const std::string& text) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(text);
  EXPECT_FALSE(read.ok()) << text;
  return read.ok() ? "" : formatError(read.error());
}

TEST(StereoScenario, IsReadAndHasThePeriodsOneAndTwo) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(stereoText("{ eye_distance = 0.1 }"));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  ASSERT_TRUE(read->stereo);
  EXPECT_EQ(read->stereo->eye_distance, 0.1f);
  EXPECT_EQ(read->periods, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_TRUE(folder.read(stereoText("{}", "periods = [2]\n")).ok());
  EXPECT_FALSE(folder.read(validScenario())->stereo);
}

TEST(StereoScenario, HasAnotherHashThanTheSameSceneForOneEye) {
  const ScenarioFolder folder;
  const std::string one_eye = changed(validScenario(), "periods = [1, 2, \"never\"]", "periods = [1, 2]");
  EXPECT_NE(folder.read(stereoText("{ eye_distance = 0.1 }"))->hash, folder.read(one_eye)->hash);
  EXPECT_NE(folder.read(stereoText("{ eye_distance = 0.1 }"))->hash, folder.read(stereoText("{ eye_distance = 0.2 }"))->hash);
}

TEST(StereoScenario, RefusesEyesThatAreNotApart) {
  for (const char* distance : {"0", "-0.06", "nan", "\"wide\""}) {
    const std::string message = refusal(stereoText(std::string("{ eye_distance = ") + distance + " }"));
    EXPECT_NE(message.find("eye_distance"), std::string::npos) << message;
  }
  EXPECT_NE(refusal(stereoText("{ eye_distanc = 0.06 }")).find("did you mean 'eye_distance'?"), std::string::npos);
  EXPECT_FALSE(refusal(stereoText("0.06")).empty());
}

TEST(StereoScenario, RefusesPeriodsThatNoPairHas) {
  for (const char* periods : {"[1, 2, 4]", "[1]", "[2, \"never\"]"}) {
    const std::string message = refusal(stereoText("{}", std::string("periods = ") + periods + "\n"));
    EXPECT_NE(message.find("expected [1, 2]"), std::string::npos) << message;
  }
}

class Eyes : public testing::Test {
 protected:
  Eyes() {
    scenario_.objects.resize(1);
    scenario_.objects[0].name = "ball";
    scenario_.objects[0].motion.spin_rad_per_frame = 0.3f;
    scenario_.uniforms = {{"Scene.time", Semantic::kTime, {}},
                          {"Scene.frame", Semantic::kFrame, {}},
                          {"Scene.walk", RandomWalkTrack{{0}, {1}, 2, 5}, {}}};
    session_.camera.path = TrackPath{RandomWalkTrack{{1, 2, 5}, {2, 1, 2}, 3, 9}, FixedTrack{{0, 0.5f, 0}}};
    session_.speed = 1.5f;
  }

  FrameState at(int image) {
    scenario_.stereo = Stereo{kEyeDistance};
    return evaluateFrame(scenario_, session_, image);
  }
  FrameState forOneEye(int frame) {
    scenario_.stereo.reset();
    return evaluateFrame(scenario_, session_, frame);
  }
  std::vector<std::byte> block(const FrameState& state) const {
    std::vector<BlockMember> members(3);
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i].name = scenario_.uniforms[i].member.substr(6);
      members[i].offset = static_cast<std::uint32_t>(4 * i);
    }
    members[1].scalar = ScalarKind::kInt;
    return fillBlock(scenario_, session_, state, 0, "Scene", members, 16);
  }

  Scenario scenario_;
  SessionSpec session_;
};

TEST_F(Eyes, AreEyeDistanceApartAlongTheRightAxisAroundTheCamera) {
  for (const int moment : {0, 1, 7}) {
    const FrameState left = at(2 * moment), right = at(2 * moment + 1), between = forOneEye(moment);
    const glm::vec3 apart = right.camera_position - left.camera_position;
    EXPECT_NEAR(glm::length(apart), kEyeDistance, 1e-6);
    const glm::vec3 axis(between.view[0][0], between.view[1][0], between.view[2][0]);
    EXPECT_NEAR(glm::dot(apart, axis), kEyeDistance, 1e-6);
    EXPECT_NEAR(glm::length((left.camera_position + right.camera_position) * 0.5f - between.camera_position), 0, 1e-6);
    for (const FrameState& eye : {left, right}) {
      const glm::vec4 own = eye.view * glm::vec4(eye.camera_position, 1);
      EXPECT_NEAR(glm::length(glm::vec3(own)), 0, 1e-5) << "the eye is the origin of its view";
    }
    for (int column = 0; column < 3; ++column) EXPECT_EQ(left.view[column], right.view[column]) << "the axes are parallel";
  }
}

TEST_F(Eyes, SeeTheSameMoment) {
  for (const int moment : {0, 1, 7}) {
    const FrameState left = at(2 * moment), right = at(2 * moment + 1), between = forOneEye(moment);
    EXPECT_EQ(left.frame, moment);
    EXPECT_EQ(right.frame, moment);
    EXPECT_EQ(left.time_s, between.time_s);
    EXPECT_EQ(right.time_s, between.time_s);
    EXPECT_EQ(left.models, between.models);
    EXPECT_EQ(right.models, between.models);
    EXPECT_EQ(left.projection, right.projection);
    EXPECT_EQ(block(left), block(right));
    EXPECT_EQ(block(left), block(between));
  }
  EXPECT_NE(block(at(2)), block(at(4)));
}

}  // namespace
}  // namespace reprise

// Where cameras are: recordings between their rows, models' cameras, shake and cuts, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "profiler/scene/handheld.h"
#include "profiler/scene/frame_state.h"
#include "profiler/scene/track.h"

namespace reprise {
namespace {

constexpr float kTolerance = 1e-5f;
constexpr float kHalfSqrt2 = 0.70710678f;

Scenario tenFramesASecond() {
  Scenario scenario;
  scenario.width = 200;
  scenario.height = 100;
  scenario.frame_time_s = 0.1f;
  return scenario;
}

FrameState stateAt(const Camera& camera, int frame) {
  SessionSpec session;
  session.camera = camera;
  return evaluateFrame(tenFramesASecond(), session, frame);
}

glm::vec3 aheadOf(const FrameState& state) { return -glm::vec3(state.view[0][2], state.view[1][2], state.view[2][2]); }

void expectNear(const glm::vec3& found, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], kTolerance) << "component " << i;
}

// Turns from looking along -z to looking along -x (a quarter about +y) within a second.
Camera quarterTurn() {
  Camera camera;
  camera.path = RecordedPath{{{0, {1, 2, 3}, {0, 0, 0, 1}, 40}, {1, {3, 2, 1}, {0, kHalfSqrt2, 0, kHalfSqrt2}, 60}}};
  return camera;
}

TEST(RecordedCamera, MovesLinearlyAndTurnsEvenly) {
  for (const int frame : {0, 3, 5, 10}) {
    const FrameState state = stateAt(quarterTurn(), frame);
    const float part = static_cast<float>(frame) / 10, angle = part * 1.5707963f;
    expectNear(state.camera_position, {1 + 2 * part, 2, 3 - 2 * part});
    expectNear(aheadOf(state), {-std::sin(angle), 0, -std::cos(angle)});
    expectNear(glm::vec3(state.view * glm::vec4(state.camera_position, 1)), {0, 0, 0});
    EXPECT_NEAR(-1 / state.projection[1][1], std::tan((40 + 20 * part) * 0.5f * 0.017453293f), kTolerance);
  }
}

TEST(RecordedCamera, HoldsItsEnds) {
  expectNear(stateAt(quarterTurn(), 25).camera_position, {3, 2, 1});
  expectNear(aheadOf(stateAt(quarterTurn(), 25)), {-1, 0, 0});
}

TEST(RecordedCamera, TurnsTheShortWay) {
  Camera camera = quarterTurn();
  for (float& part : std::get<RecordedPath>(camera.path).keys[1].rotation) part = -part;
  expectNear(aheadOf(stateAt(camera, 5)), {-kHalfSqrt2, 0, -kHalfSqrt2});
}

Camera restingCamera() {
  Camera camera;
  camera.path = TrackPath{FixedTrack{{0, 0, 4}}, FixedTrack{{0, 0, 0}}};
  return camera;
}

TEST(Cut, TurnsAboutTheTargetThenMovesFromItsFrameOn) {
  Camera camera = restingCamera();
  camera.cuts = {{0.7f, 90, {0, 1, 0}}};
  expectNear(stateAt(camera, 6).camera_position, {0, 0, 4});
  expectNear(stateAt(camera, 7).camera_position, {4, 1, 0});
  expectNear(aheadOf(stateAt(camera, 7)), {-1, 0, 0});
}

TEST(Cut, AddsUpWithTheNext) {
  Camera camera = restingCamera();
  camera.cuts = {{0.1f, 90, {0, 0, 0}}, {0.2f, 90, {0, 0, 1}}};
  expectNear(stateAt(camera, 2).camera_position, {0, 0, -3});
}

TEST(Cut, TurnsARecordedCameraInPlace) {
  Camera camera = quarterTurn();
  camera.cuts = {{0, 90, {0, 0, 0}}};
  expectNear(stateAt(camera, 0).camera_position, {1, 2, 3});
  expectNear(aheadOf(stateAt(camera, 0)), {-1, 0, 0});
}

// A point that lay in the middle of the last frame is outside of this one's.
TEST(Cut, TakesWhatWasSeenOutOfSight) {
  Camera camera = quarterTurn();
  camera.cuts = {{0.5f, 120, {0, 0, 0}}};
  const FrameState before = stateAt(camera, 4), after = stateAt(camera, 5);
  const glm::vec3 seen = before.camera_position + 5.0f * aheadOf(before);
  const glm::vec4 clip = after.projection * after.view * glm::vec4(seen, 1);
  EXPECT_TRUE(clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w);
}

TEST(Handheld, StaysWithinItsBoundsAndMovesSmoothly) {
  const Handheld handheld{0.02f, 0.5f, 2, 7};
  glm::vec3 last = shakeAt(handheld, {0, 0, 1}).move, largest(0);
  for (int i = 1; i < 2000; ++i) {
    const Shake shake = shakeAt(handheld, {i / 60.0, 0, 1});
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(shake.move[k]), 0.02f);
      EXPECT_LE(std::abs(shake.turn_rad[k]), 0.5f * 0.0174533f);
      // No faster than the fastest wave at full amplitude: 2 pi 1.71 f a.
      EXPECT_LE(std::abs(shake.move[k] - last[k]), 0.02f * 6.2832f * 1.71f * 2 / 60);
      largest[k] = std::max(largest[k], std::abs(shake.move[k]));
    }
    last = shake.move;
  }
  for (int k = 0; k < 3; ++k) EXPECT_GT(largest[k], 0.01f);
}

TEST(Handheld, IsGivenByItsSeedAndTheScenarios) {
  const auto moveAt = [](std::uint32_t seed, std::uint32_t scenario_seed) { return shakeAt({1, 1, 2, seed}, {0.3, 0, scenario_seed}).move; };
  EXPECT_EQ(moveAt(1, 1), moveAt(1, 1));
  EXPECT_NE(moveAt(1, 1), moveAt(2, 1));
  EXPECT_NE(moveAt(1, 1), moveAt(1, 2));
}

TEST(Handheld, ShakesAnyPathByItsOffset) {
  Camera camera = restingCamera();
  camera.handheld = Handheld{0.1f, 0, 2, 3};
  const Shake shake = shakeAt(*camera.handheld, {0.3f, 0, 1});
  expectNear(stateAt(camera, 3).camera_position, glm::vec3(0, 0, 4) + shake.move);
  expectNear(aheadOf(stateAt(camera, 3)), {0, 0, -1});
}

TEST(ModelCamera, FollowsItsNodeAndTheModel) {
  GltfScene scene;
  scene.nodes.resize(2);
  scene.nodes[0].translation = {1, 0, 0};
  scene.nodes[1].parent = 0;
  scene.nodes[1].rotation = {kHalfSqrt2, 0, kHalfSqrt2, 0};
  scene.nodes[1].scale = glm::vec3(3);
  scene.nodes[1].camera = 0;
  scene.order = {0, 1};
  scene.cameras.resize(1);
  scene.animations.push_back({"slide", 10, {{0, GltfTarget::kTranslation, GltfInterpolation::kLinear, {0, 10}, {1, 0, 0, 11, 0, 0}, 3}}});
  Scenario scenario = tenFramesASecond();
  scenario.models.resize(1);
  scenario.models[0].motion.translate = FixedTrack{{0, 2, 0}};
  scenario.models[0].scene = std::make_shared<const GltfScene>(scene);
  SessionSpec session;
  session.camera.path = ModelCameraPath{"", 0, 0, 1, {}};
  const FrameState state = evaluateFrame(scenario, session, 20);
  expectNear(state.camera_position, {3, 2, 0});
  expectNear(aheadOf(state), {-1, 0, 0});
}

TEST(Flicker, IsConstantBetweenItsDraws) {
  const Track track = FlickerTrack{{1, 5}, {0.5f, 2}, 10, 3};
  EXPECT_EQ(evaluateTrack(track, 0.31, 1), evaluateTrack(track, 0.39, 1));
  EXPECT_NE(evaluateTrack(track, 0.31, 1), evaluateTrack(track, 0.41, 1));
  const auto values = evaluateTrack(track, 0.31, 1);
  EXPECT_NEAR((values[0] - 1) / 0.5f, (values[1] - 5) / 2, 1e-5);
}

TEST(Flicker, StaysWithinItsBoundsAndUsesThem) {
  float low = 9, high = -9;
  for (int draw = 0; draw < 200; ++draw) {
    const float value = evaluateTrack(FlickerTrack{{1}, {0.5f}, 10, 3}, draw / 10.0, 1)[0];
    EXPECT_GE(value, 0.5f);
    EXPECT_LE(value, 1.5f);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_LT(low, 0.6f);
  EXPECT_GT(high, 1.4f);
}

TEST(Flicker, IsGivenByItsSeeds) {
  const auto valueOf = [](std::uint32_t seed, std::uint32_t scenario_seed) { return evaluateTrack(FlickerTrack{{0}, {1}, 10, seed}, 0.5, scenario_seed); };
  EXPECT_EQ(valueOf(1, 1), valueOf(1, 1));
  EXPECT_NE(valueOf(1, 1), valueOf(2, 1));
  EXPECT_NE(valueOf(1, 1), valueOf(1, 2));
}

}  // namespace
}  // namespace reprise

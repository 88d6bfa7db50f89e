// Cameras, projections, models and the bytes of uniform blocks.
#include "profiler/scene/frame_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>

namespace reprise {
namespace {

Scenario oneBall() {
  Scenario scenario;
  scenario.width = 200;
  scenario.height = 100;
  scenario.objects.resize(1);
  scenario.objects[0].name = "ball";
  return scenario;
}

SessionSpec lookingFrom(std::vector<float> eye) {
  SessionSpec session;
  session.camera.path = TrackPath{FixedTrack{std::move(eye)}, FixedTrack{{0, 0, 0}}};
  session.camera.near_plane = 0.5f;
  session.camera.far_plane = 20;
  return session;
}

glm::vec3 projected(const FrameState& state, const glm::vec3& world) {
  const glm::vec4 clip = state.projection * state.view * glm::vec4(world, 1);
  return glm::vec3(clip) / clip.w;
}

struct Planes {
  bool orthographic, reverse_z;
};
class Projection : public testing::TestWithParam<Planes> {};

TEST_P(Projection, MapsTheNearAndFarPlanesToTheEndsOfDepth) {
  SessionSpec session = lookingFrom({0, 0, 5});
  session.camera.orthographic = GetParam().orthographic;
  session.camera.reverse_z = GetParam().reverse_z;
  const FrameState state = evaluateFrame(oneBall(), session, 0);
  EXPECT_NEAR(projected(state, {0, 0, 4.5f}).z, GetParam().reverse_z ? 1 : 0, 1e-5);
  EXPECT_NEAR(projected(state, {0, 0, -15}).z, GetParam().reverse_z ? 0 : 1, 1e-5);
}

TEST_P(Projection, PutsUpAtTheTopAndRightAtTheRight) {
  SessionSpec session = lookingFrom({0, 0, 5});
  session.camera.orthographic = GetParam().orthographic;
  session.camera.reverse_z = GetParam().reverse_z;
  session.camera.ortho_height = 4;
  session.camera.fov_y_deg = 90;
  const FrameState state = evaluateFrame(oneBall(), session, 0);
  // At the target's depth the view is 4 high if orthographic, else 2 * 5 * tan(45 degrees); twice as wide.
  const float half_height = GetParam().orthographic ? 2 : 5;
  const glm::vec3 top = projected(state, {0, half_height, 0}),
                  right = projected(state, {2 * half_height, 0, 0});
  EXPECT_NEAR(top.x, 0, 1e-5);
  EXPECT_NEAR(top.y, -1, 1e-5);
  EXPECT_NEAR(right.x, 1, 1e-5);
  EXPECT_NEAR(right.y, 0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Projection,
                         testing::Values(Planes{false, false}, Planes{false, true}, Planes{true, false},
                                         Planes{true, true}),
                         [](const auto& each) {
                           return std::string(each.param.orthographic ? "Orthographic" : "Perspective") +
                                  (each.param.reverse_z ? "ReverseZ" : "");
                         });

TEST(Projection, TakesAFarPlaneAtInfinityToItsEndOfDepth) {
  for (const bool reverse_z : {false, true}) {
    SessionSpec session = lookingFrom({0, 0, 5});
    session.camera.reverse_z = reverse_z;
    session.camera.far_plane = 1e7f;
    const FrameState distant = evaluateFrame(oneBall(), session, 0);
    session.camera.far_plane = std::numeric_limits<float>::infinity();
    const FrameState state = evaluateFrame(oneBall(), session, 0);
    EXPECT_NEAR(projected(state, {0, 0, 4.5f}).z, reverse_z ? 1 : 0, 1e-5);
    EXPECT_NEAR(projected(state, {0, 0, -1e6f}).z, reverse_z ? 0 : 1, 1e-5);
    for (const float z : {4.0f, 0.0f, -100.0f}) EXPECT_NEAR(projected(state, {1, 2, z}).z, projected(distant, {1, 2, z}).z, 1e-6);
  }
}

TEST(Camera, OrbitsByItsStepAFrame) {
  SessionSpec session;
  OrbitPath orbit;
  orbit.target = {1, 2, 3};
  orbit.radius = 4;
  orbit.height = 0.5f;
  orbit.radians_per_frame = static_cast<float>(std::numbers::pi / 8);
  session.camera.path = orbit;
  const FrameState start = evaluateFrame(oneBall(), session, 0),
                   quarter = evaluateFrame(oneBall(), session, 4);
  EXPECT_LT(glm::distance(start.camera_position, glm::vec3(1, 2.5f, 7)), 1e-5f);
  EXPECT_LT(glm::distance(quarter.camera_position, glm::vec3(5, 2.5f, 3)), 1e-5f);
  EXPECT_LT(glm::length(glm::vec2(projected(quarter, {1, 2, 3}))), 1e-5f) << "the target lies in the middle";
  session.speed = 2;
  EXPECT_LT(glm::distance(evaluateFrame(oneBall(), session, 2).camera_position, quarter.camera_position),
            1e-5f);
}

TEST(Camera, MayLookAlongItsUpVector) {
  const FrameState state = evaluateFrame(oneBall(), lookingFrom({0, 5, 0}), 0);
  EXPECT_LT(glm::length(glm::vec2(projected(state, {0, 0, 0}))), 1e-5f);
  EXPECT_TRUE(std::isfinite(projected(state, {1, 0, 1}).x));
}

TEST(Models, ApplyScaleThenRotationXYZThenTranslation) {
  Scenario scenario = oneBall();
  scenario.objects[0].motion.translate = FixedTrack{{10, 20, 30}};
  scenario.objects[0].motion.rotate_deg = FixedTrack{{90, 90, 0}};
  scenario.objects[0].motion.scale = FixedTrack{{1, 2, 3}};
  const FrameState state = evaluateFrame(scenario, lookingFrom({0, 0, 5}), 0);
  // y: scaled to (0, 2, 0), about x to (0, 0, 2), about y to (2, 0, 0), moved.
  const glm::vec3 moved = state.models[0] * glm::vec4(0, 1, 0, 1);
  EXPECT_LT(glm::distance(moved, glm::vec3(12, 20, 30)), 1e-4f);
}

TEST(Models, SpinByTheirStepAFrame) {
  Scenario scenario = oneBall();
  scenario.objects[0].motion.spin_axis = {0, 0, 2};
  scenario.objects[0].motion.spin_rad_per_frame = static_cast<float>(std::numbers::pi / 6);
  const FrameState state = evaluateFrame(scenario, lookingFrom({0, 0, 5}), 3);
  EXPECT_LT(glm::distance(glm::vec3(state.models[0] * glm::vec4(1, 0, 0, 1)), glm::vec3(0, 1, 0)), 1e-5f);
}

TEST(Models, MoveAsTheSessionSaysWhereItDoes) {
  Scenario scenario = oneBall();
  scenario.objects.push_back(scenario.objects[0]);
  scenario.objects[1].name = "other";
  SessionSpec session = lookingFrom({0, 0, 5});
  session.motions["other"].translate = FixedTrack{{7, 0, 0}};
  const FrameState state = evaluateFrame(scenario, session, 0);
  EXPECT_EQ(state.models[0][3].x, 0);
  EXPECT_EQ(state.models[1][3].x, 7);
}

TEST(FrameState, StandsStillAtSpeedZero) {
  Scenario scenario = oneBall();
  scenario.objects[0].motion.translate = OscillationTrack{{0, 0, 0}, {1, 1, 1}, 1, 0.5f};
  scenario.objects[0].motion.spin_rad_per_frame = 0.1f;
  SessionSpec session;
  session.speed = 0;
  const FrameState first = evaluateFrame(scenario, session, 0), later = evaluateFrame(scenario, session, 77);
  EXPECT_EQ(first.models[0], later.models[0]);
  EXPECT_EQ(first.view, later.view);
}

BlockMember memberAt(const std::string& name, int rows, int columns, std::uint32_t offset) {
  BlockMember member;
  member.name = name;
  member.rows = rows;
  member.columns = columns;
  member.offset = offset;
  member.matrix_stride = columns > 1 ? 16 : 0;
  return member;
}

template <typename T>
T valueAt(const std::vector<std::byte>& block, std::size_t offset) {
  T value;
  std::memcpy(&value, block.data() + offset, sizeof value);
  return value;
}

// std140 of: mat3 normal; vec3 eye; float gain; int steps; mat2x3 rows (row_major); float weights[3]; vec3
// sun.color.
struct Std140 {
  Scenario scenario = oneBall();
  SessionSpec session = lookingFrom({1, 2, 5});
  std::vector<BlockMember> members = {memberAt("normal", 3, 3, 0),     memberAt("eye", 3, 1, 48),
                                      memberAt("gain", 1, 1, 60),      memberAt("steps", 1, 1, 64),
                                      memberAt("rows", 3, 2, 80),      memberAt("weights", 1, 1, 128),
                                      memberAt("sun.color", 3, 1, 176)};
  Std140() {
    members[3].scalar = ScalarKind::kInt;
    members[4].row_major = true;
    members[5].array_length = 3;
    members[5].array_stride = 16;
    scenario.objects[0].motion.rotate_deg = FixedTrack{{20, 30, 40}};
    scenario.objects[0].motion.scale = FixedTrack{{1, 2, 4}};
    scenario.uniforms = {{"B.normal", Semantic::kNormalMatrix, {}},
                         {"B.eye", Semantic::kCameraPosition, {}},
                         {"B.gain", Track(FixedTrack{{0.5f}}), {}},
                         {"B.steps", Track(FixedTrack{{-2.6f}}), {}},
                         {"B.rows", Track(FixedTrack{{1, 2, 3, 4, 5, 6}}), {}},
                         {"B.weights", Track(FixedTrack{{7, 8, 9}}), {}},
                         {"B.sun.color", Track(FixedTrack{{10, 11, 12}}), {}},
                         {"Other.gain", Track(FixedTrack{{99}}), {}}};
  }
  std::vector<std::byte> fill() const {
    return fillBlock(scenario, session, evaluateFrame(scenario, session, 0), 0, "B", members, 192);
  }
};

TEST(FillBlock, PutsScalarsAndVectorsAtTheirOffsets) {
  const std::vector<std::byte> block = Std140().fill();
  ASSERT_EQ(block.size(), 192u);
  EXPECT_EQ(valueAt<glm::vec3>(block, 48), glm::vec3(1, 2, 5));
  EXPECT_EQ(valueAt<float>(block, 60), 0.5f);
  EXPECT_EQ(valueAt<std::int32_t>(block, 64), -3);
  EXPECT_EQ(valueAt<glm::vec3>(block, 176), glm::vec3(10, 11, 12));
}

TEST(FillBlock, StridesThroughArrays) {
  const std::vector<std::byte> block = Std140().fill();
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(valueAt<float>(block, 128 + 16 * i), 7 + static_cast<float>(i));
}

TEST(FillBlock, TransposesRowMajorMatrices) {
  // Columns (1, 2, 3) and (4, 5, 6): three rows of two.
  const std::vector<std::byte> block = Std140().fill();
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(valueAt<float>(block, 80 + 16 * row), 1 + static_cast<float>(row));
    EXPECT_EQ(valueAt<float>(block, 84 + 16 * row), 4 + static_cast<float>(row));
  }
}

TEST(FillBlock, GivesTheInverseTransposeAsNormalMatrix) {
  const Std140 layout;
  const std::vector<std::byte> block = layout.fill();
  const glm::mat3 model(evaluateFrame(layout.scenario, layout.session, 0).models[0]);
  for (int i = 0; i < 3; ++i) {
    const auto column = valueAt<glm::vec3>(block, static_cast<std::size_t>(i) * 16);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(glm::dot(column, model[k]), i == k ? 1 : 0, 1e-5);
  }
}

TEST(FillBlock, LeavesPaddingAndUnboundMembersZero) {
  Std140 layout;
  layout.scenario.uniforms.clear();
  for (const std::byte byte : layout.fill()) EXPECT_EQ(byte, std::byte{0});
  const std::vector<std::byte> block = Std140().fill();
  for (const std::size_t padding : {12u, 28u, 44u, 68u, 132u, 188u})
    EXPECT_EQ(valueAt<std::uint32_t>(block, padding), 0u);
}

TEST(FillBlock, TakesTheSessionsUniformsFirst) {
  Std140 layout;
  layout.session.uniforms["B.gain"] = FixedTrack{{0.25f}};
  EXPECT_EQ(valueAt<float>(layout.fill(), 60), 0.25f);
}

TEST(FillBlock, WritesMatricesSuchThatTheShaderSeesTheSame) {
  Scenario scenario = oneBall();
  scenario.uniforms = {{"B.clip", Semantic::kViewProjection, {}}, {"B.model", Semantic::kModel, {}}};
  scenario.objects[0].motion.translate = FixedTrack{{3, 4, 5}};
  const SessionSpec session = lookingFrom({1, 2, 5});
  const FrameState state = evaluateFrame(scenario, session, 0);
  const std::vector<std::byte> block = fillBlock(
      scenario, session, state, 0, "B", {memberAt("clip", 4, 4, 0), memberAt("model", 3, 4, 64)}, 128);
  EXPECT_EQ(valueAt<glm::mat4>(block, 0), state.projection * state.view);
  EXPECT_EQ(valueAt<glm::vec3>(block, 64 + 48), glm::vec3(3, 4, 5));
}

TEST(FillBlock, CountsTimeFramesAndPixels) {
  Scenario scenario = oneBall();
  scenario.frame_time_s = 0.25f;
  scenario.uniforms = {{"B.now", Semantic::kTime, {}},
                       {"B.frame", Semantic::kFrame, {}},
                       {"B.size", Semantic::kResolution, {}}};
  std::vector<BlockMember> members = {memberAt("now", 1, 1, 0), memberAt("frame", 1, 1, 4),
                                      memberAt("size", 4, 1, 16)};
  members[1].scalar = ScalarKind::kUint;
  SessionSpec session = lookingFrom({1, 2, 5});
  session.speed = 2;
  const std::vector<std::byte> block =
      fillBlock(scenario, session, evaluateFrame(scenario, session, 6), 0, "B", members, 32);
  EXPECT_EQ(valueAt<float>(block, 0), 3);
  EXPECT_EQ(valueAt<std::uint32_t>(block, 4), 6u);
  EXPECT_EQ(valueAt<glm::vec4>(block, 16), glm::vec4(200, 100, 1 / 200.0f, 1 / 100.0f));
}

}  // namespace
}  // namespace reprise

// Passes before the shader: what they leave in their textures, where shadows fall, and that variants see the same.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "profiler/session/job.h"
#include "tests/passes/pass_scene.h"
#include "tests/passes/two_passes.h"

namespace reprise {
namespace {

constexpr std::size_t kPixels = 128 * 128;

// What a frame has where nothing is drawn.
constexpr glm::vec3 kBackground(-7, -7, -7);

// Whether the point sees the light, and where the point is.
const char* kLitPoint = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0, std140) uniform StandardShadow { mat4 shadow_view_projection; };
layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map;
void main() {
  vec4 place = shadow_view_projection * vec4(world_position, 1);
  vec3 seen = vec3(place.xy / place.w * 0.5 + 0.5, place.z / place.w);
  result = vec4(textureLod(shadow_map, seen, 0.0), world_position);
}
)";

void expectSilence(const PassScene& scene) {
  for (const std::string& message : scene.context().validation_messages()) ADD_FAILURE() << message;
}

struct Shadows {
  std::size_t dark = 0, lit = 0, wrong = 0;
};

// A ball of radius 0.8 over a floor in parallel light: the floor is dark where the ray to the light passes the ball's centre within its
// radius. The edge, and what the map's texels cannot resolve, is left out.
Shadows shadowsOf(const std::vector<float>& frame, const glm::vec3& center, const glm::vec3& to_light) {
  constexpr float kRadius = 0.8f, kEdge = 0.06f;
  Shadows shadows;
  for (std::size_t at = 0; at < frame.size(); at += 4) {
    const glm::vec3 point(frame[at + 1], frame[at + 2], frame[at + 3]);
    if (point == kBackground || std::abs(point.y) > 1e-3f || glm::length(point) > 2.4f) continue;
    const glm::vec3 offset = center - point;
    const float distance = glm::length(offset - to_light * glm::dot(offset, to_light));
    if (std::abs(distance - kRadius) < kEdge) continue;
    const bool dark = distance < kRadius;
    ++(dark ? shadows.dark : shadows.lit);
    shadows.wrong += (frame[at] == 0) != dark;
  }
  return shadows;
}

TEST(ShadowPass, DarkensTheFloorBehindAMovingBallWhereTheLightSaysSo) {
  PassScene scene({{"a.frag", kLitPoint}}, kRender + R"(
[[object]]
name = "ball"
mesh = { kind = "sphere", radius = 0.8, segments_u = 96, segments_v = 48 }
motion = { translate = { key_frames = [{ at_s = 0, value = [-0.8, 1.2, 0] }, { at_s = 0.1, value = [0.6, 1.5, 0.4] }] } }
[[object]]
name = "floor"
mesh = { kind = "plane", size = 8 }
)" + kSun + kSessions);
  const glm::vec3 to_light = glm::normalize(glm::vec3(3, 6, 2));
  const glm::vec3 centers[] = {{-0.8f, 1.2f, 0}, {0.6f, 1.5f, 0.4f}};
  for (const int step : {0, 1}) {
    const Shadows shadows = shadowsOf(scene.original(step * 6), centers[step], to_light);
    EXPECT_GT(shadows.dark, 200u) << step;
    EXPECT_GT(shadows.lit, 1000u) << step;
    EXPECT_EQ(shadows.wrong, 0u) << step;
  }
  expectSilence(scene);
}

TEST(ShadowPass, LeavesOutWhatItsObjectsDoNotName) {
  const std::string objects = R"(
[[object]]
name = "ball"
mesh = { kind = "sphere", radius = 0.8 }
motion = { translate = [0, 1.2, 0] }
[[object]]
name = "floor"
mesh = { kind = "plane", size = 8 }
)";
  PassScene scene({{"a.frag", kLitPoint}}, kRender + objects + kSun + "objects = [\"floor\"]\n" + kSessions);
  const std::vector<float> frame = scene.original(0);
  const glm::vec3 to_light = glm::normalize(glm::vec3(3, 6, 2));
  const Shadows shadows = shadowsOf(frame, {0, 1.2f, 0}, to_light);
  EXPECT_EQ(shadows.wrong, shadows.dark) << "the floor is lit everywhere, and all that would be dark is not";
  EXPECT_GT(shadows.dark, 200u);
}

// The light and the camera see the same then: the map holds the depth that the camera finds, skinned limbs and all.
TEST(ShadowPass, SeesASkinnedWalkerAsACameraInItsPlaceDoes) {
  const std::string eye = "{ eye = [1.5, 2, 3], target = [0, 0.9, 0], fov_y_deg = 45, near = 0.5, far = 20 }";
  PassScene scene({{"a.frag", R"(#version 450
layout(location = 0) in vec3 object_position;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0) uniform sampler2D walker_depth;
void main() { result = vec4(texelFetch(walker_depth, ivec2(gl_FragCoord.xy), 0).r, gl_FragCoord.z, object_position.xy); }
)"}},
                  kRender + R"(
[[model]]
name = "man"
kind = "figure"
motion = { translate = { oscillate = { base = [0, 0, 0], amplitude = [0.4, 0, 0], period_s = 1 } } }
[[pass]]
name = "walker_depth"
kind = "shadow"
size = 128
slope_bias = 0
light = )" + eye + R"(
[[session]]
name = "train"
role = "training"
camera = )" + eye + R"(
[[session]]
name = "check"
role = "validation"
camera = )" + eye + "\n");
  std::vector<float> last;
  for (const int frame : {0, 13}) {
    const std::vector<float> shown = scene.original(frame);
    std::size_t covered = 0;
    for (std::size_t at = 0; at < shown.size(); at += 4) {
      if (shown[at + 1] == kBackground.x) continue;
      ++covered;
      EXPECT_EQ(shown[at], shown[at + 1]) << "frame " << frame << ", pixel " << at / 4;
    }
    EXPECT_GT(covered, kPixels / 50) << frame;
    EXPECT_NE(shown, last) << "the walker stands still, so this says little";
    last = shown;
  }
  expectSilence(scene);
}

const char* kGBuffer = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 0) out vec4 normal_out;
layout(location = 1) out vec4 place_out;
void main() { normal_out = vec4(normalize(world_normal), 1); place_out = vec4(world_position, 2); }
)";

const std::string kGBufferScene = kRender + R"(
[[object]]
name = "knot"
mesh = { kind = "torus_knot", segments_u = 64, segments_v = 12 }
motion = { spin_rad_per_frame = 0.05 }
[[pass]]
name = "geometry"
kind = "gbuffer"
fragment = "gbuffer.frag"
depth = "depth_map"
outputs = [{ texture = "normal_map", format = "rgba16_sfloat" }, { texture = "place_map", format = "rgba32_sfloat" }]
)" + kSessions;

// The largest error of normal, place and depth in the textures against what the shader itself has there; kept apart by channel.
const char* kReadsGBuffer = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0) uniform sampler2D normal_map;
layout(set = 0, binding = 1) uniform sampler2D place_map;
layout(set = 0, binding = 2) uniform sampler2D depth_map;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float normal = length(texelFetch(normal_map, at, 0).xyz - normalize(world_normal));
  vec4 place = texelFetch(place_map, at, 0);
  result = vec4(normal, length(place.xyz - world_position), abs(texelFetch(depth_map, at, 0).r - gl_FragCoord.z), place.w);
}
)";

TEST(GBufferPass, LeavesWhatItsShaderWroteInTheTexturesAndItsDepth) {
  PassScene scene({{"a.frag", kReadsGBuffer}, {"gbuffer.frag", kGBuffer}}, kGBufferScene);
  for (const int frame : {0, 5}) {
    const std::vector<float> shown = scene.original(frame);
    std::size_t covered = 0;
    for (std::size_t at = 0; at < shown.size(); at += 4) {
      if (shown[at + 3] != 2) continue;
      ++covered;
      EXPECT_LT(shown[at], 2e-3f) << "half floats";
      EXPECT_EQ(shown[at + 1], 0);
      EXPECT_EQ(shown[at + 2], 0);
    }
    EXPECT_GT(covered, kPixels / 50);
  }
  expectSilence(scene);
}

// An original that reads textures of passes, and the way of such a scenario through the worker's files.
TEST(GBufferPass, IsPlayedByJobsFromTheCopiesOfItsShaders) {
  const PassScene scene({{"a.frag", kReadsGBuffer}, {"gbuffer.frag", kGBuffer}}, kGBufferScene);
  const std::filesystem::path copy = scene.folder() / "copy" / "scenario.toml", original = scene.folder() / "original";
  ASSERT_TRUE(copyInputs(scene.subject(), copy).ok());
  ASSERT_TRUE(writePackageFiles(scene.package(asGiven()), original).ok());
  const Result<Subject> again = readSubject(copy);
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  EXPECT_EQ(again->scenario.hash, scene.subject().scenario.hash);
  Job job;
  job.scenario_path = copy.string();
  job.session = "train";
  job.original_dir = original.string();
  job.entries = {{original.string(), 1}};
  job.frames = 3;
  const Result<JobResult> result = runJob(job, {});
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  for (const ErrorRow& row : result->errors.at(0)) {
    EXPECT_GT(row.covered, kPixels / 50);
    EXPECT_EQ(row.errors.at("rms"), 0);
  }
  job.scenario_path = (scene.folder() / "scene.toml").string();
  const Result<JobResult> uncompiled = runJob(job, {});
  ASSERT_FALSE(uncompiled.ok());
  EXPECT_EQ(uncompiled.error().code, "session.pass");
}

TEST(Passes, ReadThoseBeforeThem) {
  PassScene scene({{"a.frag", kShades}, {"light.frag", kLight}}, kTwoPasses);
  const std::vector<float> frame = scene.original(4);
  std::size_t covered = 0;
  for (std::size_t at = 0; at < frame.size(); at += 4) {
    if (frame[at + 1] == kBackground.x) continue;
    ++covered;
    EXPECT_EQ(glm::vec3(frame[at + 1], frame[at + 2], frame[at + 3]), glm::vec3(3, 6, 2));
  }
  EXPECT_GT(covered, kPixels / 10);
  expectSilence(scene);
}

TEST(Passes, AreTheSameForAVariantThatAlwaysRefreshesAndForItsOriginal) {
  PassScene scene({{"a.frag", kShades}, {"light.frag", kLight}}, kTwoPasses);
  for (const char* strategy : {"branch", "two_pass"}) {
    VariantOptions options;
    options.strategy = strategy;
    options.encoding = Encoding::kRgba32f;
    options.block_pixels = 8;
    options.ranges.depth_near = 0.5f;
    options.ranges.depth_far = 20;
    const std::unique_ptr<Player> variant = scene.player(options), original = scene.player(asGiven());
    for (int frame = 0; frame < 4; ++frame) {
      const std::vector<float> expected = scene.play(*original, frame), cached = scene.play(*variant, frame, 1);
      EXPECT_EQ(cached, expected) << strategy << ", frame " << frame;
    }
  }
  expectSilence(scene);
}

}  // namespace
}  // namespace reprise

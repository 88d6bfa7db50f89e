// Jobs that cannot be done, and shaders that give no numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tests/session/measured_scene.h"

namespace reprise {
namespace {

constexpr const char* kScenario = "shaders/laws/straight_line/straight_line.toml";

std::string codeOf(const Job& job) {
  const Result<JobResult> result = runJob(job, {});
  return result.ok() ? "" : result.error().code;
}

TEST(BadJob, IsRefusedForAStatedReason) {
  const MeasuredScene scene(kScenario);
  const Job good = scene.job(JobKind::kErrors, {scene.original(), 1});
  Job job = good;
  job.session = "nowhere";
  EXPECT_EQ(codeOf(job), "session.unknown");
  job = good;
  job.entries[0].package_dir = (scene.folder() / "nowhere").string();
  EXPECT_EQ(codeOf(job), "package.missing");
  job = good;
  job.metrics = {"beauty"};
  EXPECT_EQ(codeOf(job), "job.metric");
  job = good;
  job.device = "no such device";
  EXPECT_EQ(codeOf(job), "device.unknown");
}

TEST(BadJob, PackageOfOtherShadersIsRefused) {
  const MeasuredScene scene(kScenario), other("shaders/laws/textures/textures.toml");
  EXPECT_EQ(codeOf(scene.job(JobKind::kErrors, {other.original(), 1})), "job.interface");
}

TEST(BadJob, ScenarioThatDoesNotFitTheShadersIsRefused) {
  const MeasuredScene scene(kScenario), other("shaders/laws/textures/textures.toml");
  Job job = other.job(JobKind::kErrors, {other.original(), 1});
  job.scenario_path = scene.scenario();
  const Result<JobResult> result = runJob(job, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kInput);
}

constexpr const char* kVertex = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 0) out vec3 place;
layout(push_constant) uniform Object { mat4 view_projection; } object;
void main() { place = position; gl_Position = object.view_projection * vec4(position, 1.0); }
)";

// Infinite where x is negative; the bright half keeps the shader from being all bad.
constexpr const char* kFragment = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
void main() { color = vec4(vec3(0.5 / max(sign(place.x), 0.0)), 1.0); }
)";

// Finite, but the tail takes a logarithm of what eight bits may round below zero.
constexpr const char* kBrittleFragment = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
void main() {
  float small = exp(sin(place.x * 9.0) * cos(place.y * 7.0) - 10.0);
  color = vec4(vec3(-0.05 * log(small)), 1.0);
}
)";

constexpr const char* kInfiniteScenario = R"(name = "infinite"
[shader]
fragment = "infinite.frag"
vertex = "infinite.vert"
[render]
width = 64
height = 64
frames = 2
formats = ["FORMAT"]
[[object]]
name = "ball"
mesh = { kind = "sphere" }
[uniforms]
"Object.view_projection" = "view_projection"
[[session]]
name = "still"
role = "training"
camera = { eye = [0, 0, 4], target = [0, 0, 0] }
[[session]]
name = "far"
role = "validation"
camera = { eye = [0, 0, 6], target = [0, 0, 0] }
)";

class Infinite : public testing::Test {
 protected:
  MeasuredScene sceneWith(const std::string& format, const char* fragment = kFragment) const {
    std::string text = kInfiniteScenario;
    text.replace(text.find("FORMAT"), 6, format);
    writeText(folder_ / "infinite.vert", kVertex);
    writeText(folder_ / "infinite.frag", fragment);
    writeText(folder_ / "infinite.toml", text);
    return MeasuredScene((folder_ / "infinite.toml").string());
  }

  TemporaryFolder folder_;
};

TEST_F(Infinite, PixelsAreCountedAndLeftOutOfErrors) {
  const MeasuredScene scene = sceneWith("rgba16_sfloat");
  const Result<JobResult> result = runJob(scene.job(JobKind::kErrors, {scene.original(), 1}), {});
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  for (const ErrorRow& row : result->errors.at(0)) {
    EXPECT_GT(row.nonfinite, row.covered / 3);
    EXPECT_LT(row.nonfinite, row.covered * 2 / 3);
    EXPECT_EQ(row.spoiled, 0u);
    ASSERT_FALSE(row.errors.empty());
    for (const auto& [metric, value] : row.errors) EXPECT_TRUE(std::isfinite(value)) << metric;
  }
}

TEST_F(Infinite, PixelsThatOnlyTheVariantSpoilsAreCountedApart) {
  const MeasuredScene scene = sceneWith("rgba16_sfloat", kBrittleFragment);
  VariantOptions options = countingVariant();
  options.encoding = Encoding::kRgba8;
  options.ranges.payload_min[0] = -0.3f;
  options.ranges.payload_max[0] = 1;
  const std::string variant = scene.variant("brittle", options, "small");
  const Result<JobResult> result = runJob(scene.job(JobKind::kErrors, {variant, 8}), {});
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  const std::vector<ErrorRow>& rows = result->errors.at(0);
  EXPECT_EQ(rows.at(0).spoiled, 0u);
  EXPECT_GT(rows.at(1).spoiled, rows.at(1).hits / 2);
  EXPECT_EQ(rows.at(1).spoiled, rows.at(1).nonfinite);
}

TEST_F(Infinite, ProbeNoticesEvenWhereTheTargetsFormatHidesIt) {
  const MeasuredScene scene = sceneWith("rgba8_unorm");
  const Result<JobResult> result = runJob(scene.job(JobKind::kProbe, {scene.original(), 1}), {});
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_GT(result->probes.at(0).nonfinite_color, 100u);
}

}  // namespace
}  // namespace reprise

// The crowd's hits (shaders/crowd/README.md). Where a pixel hits is decided by geometry and motion, not by the shader: a cheap one,
// which compiles in a moment, stands for the standard one here.
#include <gtest/gtest.h>

#include "cli/subject.h"
#include "cli/train.h"
#include "compiler/strategies/build_package.h"
#include "profiler/session/job.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

const char* kCheap = R"(#version 450
layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 result;
layout(set = 0, binding = 0, std140) uniform StandardShadow { mat4 shadow_view_projection; };
layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map;
void main() {
  float pattern = 0.5;
  for (int i = 1; i < 12; ++i) pattern += 0.1 * sin(world_position.x * float(i) + world_position.z) / float(i);
  vec4 place = shadow_view_projection * vec4(world_position, 1);
  result = vec4(vec3(pattern * (0.5 + 0.5 * textureLod(shadow_map, vec3(place.xy * 0.5 + 0.5, place.z), 0.0))), 1);
}
)";

class Crowd : public testing::Test {
 protected:
  void SetUp() override {
    std::string text = textOf(std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders/crowd/crowd.toml");
    text.replace(text.find("[shader]"), 8, "[shader]\nfragment = \"cheap.frag\"");
    writeText(folder_ / "cheap.frag", kCheap);
    writeText(folder_ / "crowd.toml", text);
    Result<Subject> read = readSubject(folder_ / "crowd.toml");
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    subject_ = std::move(*read);
    ASSERT_FALSE(subject_.candidates.empty());
    ASSERT_TRUE(copyInputs(subject_, folder_ / "copy" / "scenario.toml").ok());
    VariantOptions original;
    original.strategy = "original";
    write(original, "original");
    VariantOptions counting;
    counting.strategy = "two_pass";
    counting.instrumented = true;
    counting.block_pixels = 8;
    counting.ranges.depth_near = subject_.scenario.sessions.front().camera.near_plane;
    counting.ranges.depth_far = subject_.scenario.sessions.front().camera.far_plane;
    write(counting, "counting");
  }

  void write(const VariantOptions& options, const std::string& name) const {
    const Result<Package> package = buildPackage(subject_.program, subject_.candidates.front(), options, subject_.limits);
    ASSERT_TRUE(package.ok()) << formatError(package.error());
    ASSERT_TRUE(writePackageFiles(*package, folder_ / name).ok());
  }

  // Hits by covered pixels of all frames but the first, without any refresh.
  double hitRate(const std::string& session) const {
    Job job;
    job.scenario_path = (folder_ / "copy" / "scenario.toml").string();
    job.session = session;
    job.original_dir = (folder_ / "original").string();
    job.entries = {{(folder_ / "counting").string(), kNeverRefresh}};
    job.frames = 6;
    const Result<JobResult> result = runJob(job, {});
    if (!result.ok()) ADD_FAILURE() << formatError(result.error());
    double hits = 0, covered = 0;
    for (std::size_t frame = 1; result.ok() && frame < result->errors.at(0).size(); ++frame) {
      hits += static_cast<double>(result->errors[0][frame].hits);
      covered += static_cast<double>(result->errors[0][frame].covered);
    }
    return hits / covered;
  }

  TemporaryFolder folder_;
  Subject subject_;
};

TEST_F(Crowd, HitsOnAtLeast85PercentOfTheCoveredPixelsBetweenRefreshes) {
  for (const SessionSpec& session : subject_.scenario.sessions) {
    const double rate = hitRate(session.name);
    EXPECT_GE(rate, 0.85) << session.name;
    RecordProperty(session.name, std::to_string(rate));
  }
}

}  // namespace
}  // namespace reprise

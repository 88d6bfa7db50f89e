#include "tests/session/measured_scene.h"

#include <algorithm>

#include "compiler/candidates/enumerate.h"
#include "compiler/source/compile.h"
#include "compiler/strategies/build_package.h"
#include "profiler/scenario/read_scenario.h"

namespace reprise {
namespace {

Package packageOf(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options) {
  return buildPackage(program, candidate, options, {}).value();
}

}  // namespace

MeasuredScene::MeasuredScene(const std::string& scenario)
    : scenario_((std::filesystem::path(REPRISE_SOURCE_DIR) / scenario).string()), original_((folder_ / "original").string()) {
  const Scenario read = readScenario(scenario_).value();
  session_ = read.sessions.front().name;
  CompileOptions options;
  options.defines = read.defines;
  const CompiledShader vertex = compile(read.vertex_path, options).value();
  const CompiledShader fragment = compile(read.fragment_path, options).value();
  program_ = readProgram(vertex, fragment).value();
  candidates_ = enumerateCandidates(*program_.fragment, program_.analysis, program_.sources, {});
  VariantOptions as_given;
  as_given.strategy = "original";
  const Result<void> written = writePackageFiles(packageOf(program_, {}, as_given), original_);
  REPRISE_CHECK(written.ok(), formatError(written.error()));
}

std::string MeasuredScene::variant(const std::string& name, const VariantOptions& options, const std::string& payload) const {
  const auto found = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& candidate) {
    if (!payload.empty()) return candidate.name == payload;
    return candidate.kept() && candidate.values.size() == 1 && !candidate.conditional && candidate.share < 0.9;
  });
  REPRISE_CHECK(found != candidates_.end(), scenario_);
  const std::string directory = (folder_ / name).string();
  const Result<void> written = writePackageFiles(packageOf(program_, *found, options), directory);
  REPRISE_CHECK(written.ok(), formatError(written.error()));
  return directory;
}

Job MeasuredScene::job(JobKind kind, const JobEntry& entry) const {
  Job job;
  job.kind = kind;
  job.scenario_path = scenario_;
  job.session = session_;
  job.original_dir = original_;
  job.entries = {entry};
  return job;
}

VariantOptions countingVariant() {
  VariantOptions options;
  options.strategy = "two_pass";
  options.instrumented = true;
  options.block_pixels = 8;
  options.ranges.depth_near = 0.1f;
  options.ranges.depth_far = 100;
  return options;
}

}  // namespace reprise

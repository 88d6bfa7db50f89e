#include "cli/subject.h"

#include <algorithm>
#include <set>

#include "cli/motion.h"
#include "cli/standard_shaders.h"
#include "compiler/source/compile.h"
#include "compiler/strategies/build_package.h"
#include "profiler/gltf/read_gltf.h"
#include "profiler/scenario/read_scenario.h"
#include "profiler/scenario/texture_file.h"
#include "profiler/scene/shared_inputs.h"
#include "profiler/scene/texture.h"
#include "profiler/session/model_textures.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

Result<CompiledShader> compileStage(const Scenario& scenario, const std::string& path, ShaderStage stage) {
  CompileOptions options;
  options.stage = stage;
  for (const std::string& directory : scenario.include_dirs) options.include_dirs.emplace_back(directory);
  options.defines = scenario.defines;
  options.entry_point = stage == ShaderStage::kVertex ? scenario.vertex_entry_point : scenario.fragment_entry_point;
  return compile(path, options);
}

// The shaders of a G-buffer pass, as a package whose original is played.
Result<Package> compilePass(const Scenario& scenario, const PassSpec& pass) {
  REPRISE_ASSIGN(const CompiledShader fragment, compileStage(scenario, pass.fragment_path, ShaderStage::kFragment));
  const std::string& vertex_path = pass.vertex_path.empty() ? scenario.vertex_path : pass.vertex_path;
  REPRISE_ASSIGN(const CompiledShader vertex, vertex_path.empty() ? standardVertex(scenario, fragment)
                                                                  : compileStage(scenario, vertex_path, ShaderStage::kVertex));
  REPRISE_ASSIGN(ShaderProgram program, readProgram(vertex, fragment));
  nameVertexInputs(scenario, program.interface);
  VariantOptions as_given;
  as_given.strategy = "original";
  return buildPackage(program, {}, as_given, {});
}

// The shadow passes have no shaders of their own: an empty package stands for them. The scenario's hash tells the shaders of passes, too.
Result<std::vector<Package>> compilePasses(Scenario& scenario) {
  std::vector<Package> packages(scenario.passes.size());
  for (std::size_t i = 0; i < packages.size(); ++i) {
    if (scenario.passes[i].kind == ScenePassKind::kShadow) continue;
    REPRISE_ASSIGN(packages[i], compilePass(scenario, scenario.passes[i]));
    scenario.hash = contentHash(scenario.hash + recipeToJson(packages[i].original));
  }
  return packages;
}

// Compiled shaders in place of sources, and the package that the profiler plays.
Result<void> copyPass(const std::filesystem::path& directory, const Package& package, PassSpec& pass) {
  if (pass.kind == ScenePassKind::kShadow) return {};
  const Pass& played = package.original.passes.front();
  pass.package = directory.string();
  pass.vertex_path = (directory / (played.vertex_module + ".spv")).string();
  pass.fragment_path = (directory / (played.fragment_module + ".spv")).string();
  return writePackageFiles(package, directory);
}

// The model's file and those that it names, which keep their places relative to it.
Result<void> copyModel(const std::filesystem::path& directory, ModelSpec& model) {
  if (model.path.empty()) return {};
  const std::filesystem::path from = std::filesystem::path(model.path).parent_path();
  std::vector<std::string> files = model.scene->files;
  files.push_back(std::filesystem::path(model.path).filename().string());
  for (const std::string& file : files) {
    REPRISE_ASSIGN(const std::string bytes, readFile(from / file, kMostGltfBytes));
    REPRISE_TRY(writeFile(directory / file, bytes));
  }
  model.path = (directory / files.back()).string();
  return {};
}

// Told before the copies are made, of which nobody wants to hear.
Result<void> expectImages(const Subject& subject) {
  const Scenario& scenario = subject.scenario;
  for (const TextureSpec& texture : scenario.textures)
    if (texture.kind == TextureKind::kFile) REPRISE_TRY(buildTexture(texture));
  std::vector<const ShaderInterface*> interfaces = {&subject.program.interface};
  for (const Package& pass : subject.passes) interfaces.push_back(&pass.interface);
  std::set<std::string> seen;
  for (const ShaderInterface* interface : interfaces)
    for (const ModelTexture& texture : listModelTextures(scenario, *interface).textures)
      if (texture.image && seen.insert(texture.spec.path).second) REPRISE_TRY(decodeTexture(texture.spec, texture.image->bytes));
  return {};
}

}  // namespace

Result<Subject> readSubject(const std::filesystem::path& scenario_file) {
  REPRISE_ASSIGN(Subject subject, readSubjectUnranked(scenario_file));
  REPRISE_TRY(expectMotion(subject));
  subject.candidates = enumerateCandidates(*subject.program.fragment, subject.program.analysis, subject.program.sources, {});
  return subject;
}

Result<Subject> readSubjectUnranked(const std::filesystem::path& scenario_file) {
  Subject subject;
  REPRISE_ASSIGN(subject.scenario, readScenario(scenario_file));
  const Scenario& scenario = subject.scenario;
  REPRISE_ASSIGN(const CompiledShader fragment, scenario.fragment_path.empty() ? standardFragment(scenario)
                                                                               : compileStage(scenario, scenario.fragment_path, ShaderStage::kFragment));
  REPRISE_ASSIGN(const CompiledShader vertex, scenario.vertex_path.empty() ? standardVertex(scenario, fragment)
                                                                           : compileStage(scenario, scenario.vertex_path, ShaderStage::kVertex));
  REPRISE_ASSIGN(subject.program, readProgram(vertex, fragment));
  nameVertexInputs(scenario, subject.program.interface);
  REPRISE_ASSIGN(subject.passes, compilePasses(subject.scenario));
  std::vector<ShaderInterface> pass_interfaces;
  for (const Package& pass : subject.passes) pass_interfaces.push_back(pass.interface);
  REPRISE_TRY(checkBindings(scenario, subject.program.interface, pass_interfaces));
  for (const CompiledShader* shader : {&fragment, &vertex})
    subject.included.insert(subject.included.end(), shader->dependencies.begin(), shader->dependencies.end());
  subject.limits.strict_depth_with_writes =
      scenario.state.compare == DepthCompare::kLess || scenario.state.compare == DepthCompare::kGreater;
  subject.limits.stencil = scenario.state.depth_stencil;
  subject.limits.several_draws = scenario.objects.size() > 1;
  subject.limits.shared_inputs = drawsShareInputs(scenario, subject.program.interface);
  subject.orthographic = scenario.sessions.front().camera.orthographic;
  for (const SessionSpec& session : scenario.sessions)
    if (session.camera.orthographic != subject.orthographic)
      return Error{ErrorKind::kInput, "scenario.mixed_projection",
                   "session '" + session.name + "' differs from the first in its projection; one recipe serves perspective or "
                   "orthographic cameras, so split the scenario in two", {scenario.path, 0, 0}};
  return subject;
}

Result<void> copyInputs(const Subject& subject, const std::filesystem::path& scenario_file) {
  REPRISE_TRY(expectImages(subject));
  const std::filesystem::path directory = scenario_file.parent_path();
  Scenario copy = subject.scenario;
  copy.vertex_path = (directory / "vertex.spv").string();
  copy.fragment_path = (directory / "fragment.spv").string();
  copy.vertex_entry_point = copy.fragment_entry_point = "main";
  copy.include_dirs.clear();
  copy.defines.clear();
  REPRISE_TRY(writeFile(copy.vertex_path, bytesOf(subject.program.vertex_words)));
  REPRISE_TRY(writeFile(copy.fragment_path, bytesOf(subject.program.fragment_words)));
  for (std::size_t i = 0; i < copy.textures.size(); ++i) {
    TextureSpec& texture = copy.textures[i];
    if (texture.kind != TextureKind::kFile) continue;
    REPRISE_ASSIGN(const std::string bytes, readTextureFile(texture));
    texture.path = (directory / (std::to_string(i) + "_" + std::filesystem::path(texture.path).filename().string())).string();
    REPRISE_TRY(writeFile(texture.path, bytes));
  }
  for (std::size_t i = 0; i < copy.models.size(); ++i) REPRISE_TRY(copyModel(directory / ("model_" + std::to_string(i)), copy.models[i]));
  for (std::size_t i = 0; i < copy.passes.size(); ++i) REPRISE_TRY(copyPass(directory / ("pass_" + std::to_string(i)), subject.passes[i], copy.passes[i]));
  for (const SourceFile& source : subject.program.sources)
    REPRISE_TRY(writeFile(directory / "sources" / std::filesystem::path(source.path).filename(), source.text));
  return writeFile(scenario_file, writeScenario(copy, directory));
}

}  // namespace reprise

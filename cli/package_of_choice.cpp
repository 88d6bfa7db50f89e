#include "cli/package_of_choice.h"

#include <algorithm>
#include <filesystem>

#include "cli/describe_run.h"
#include "cli/motion.h"
#include "cli/train.h"
#include "cli/version.h"
#include "compiler/strategies/build_package.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::string relativeTo(const fs::path& folder, const std::string& file) {
  if (file.empty() || !fs::path(file).is_absolute()) return file;
  return fs::path(file).lexically_relative(folder).generic_string();
}

// The module with the files that it names relative to `folder`: where the sources lie on a machine is nothing that ships.
Result<std::vector<std::uint32_t>> relocated(std::span<const std::uint32_t> words, const fs::path& folder) {
  REPRISE_ASSIGN(Module module, readModule(words));
  for (Instruction& instruction : module.debug_sources)
    if (instruction.opcode == spv::Op::OpString) instruction.operands[0] = stringOperand(relativeTo(folder, stringOf(instruction.operands[0])));
  return writeModule(module);
}

fs::path folderOf(const Subject& subject) { return fs::path(subject.scenario.path).parent_path(); }

Result<void> relocate(const fs::path& folder, Package& package) {
  for (auto& [name, words] : package.modules) {
    REPRISE_ASSIGN(words, relocated(words, folder));
    for (Recipe* recipe : {&package.original, &package.variant})
      for (ModuleEntry& entry : recipe->modules)
        if (entry.name == name) entry.hash = contentHash(bytesOf(words));
  }
  for (PayloadValue& value : package.variant.payload) value.file = relativeTo(folder, value.file);
  return {};
}

// Of the shaders as they are compiled, wherever they lie.
std::string shaderHash(const Subject& subject) {
  std::string bytes;
  for (const auto* words : {&subject.program.vertex_words, &subject.program.fragment_words}) {
    const Result<std::vector<std::uint32_t>> moved = relocated(*words, folderOf(subject));
    bytes += bytesOf(moved.ok() ? *moved : *words);
  }
  return contentHash(bytes);
}

ChosenModels modelsOf(const RunResult& result) {
  ChosenModels models;
  const RunChoice& choice = result.choice;
  for (const RunCandidate& candidate : result.candidates) {
    if (candidate.id != choice.candidate_id) continue;
    models.hit_rate_mu = candidate.hit_rate_mu;
    if (candidate.error_model) {
      models.error_family = candidate.error_model->family;
      for (const RunParameter& parameter : candidate.error_model->parameters) models.error_parameters[parameter.name] = parameter.value;
    }
    for (const RunConfiguration& one : candidate.configurations) {
      if (one.strategy != choice.strategy || one.pattern != choice.pattern || one.filter != choice.filter || one.encoding != choice.encoding ||
          one.block_pixels != choice.block_pixels)
        continue;
      models.hit_ns = one.hit_ns;
      models.miss_ns = one.miss_ns;
      models.overhead_ms = one.overhead_ms;
    }
  }
  return models;
}

}  // namespace

Choice describeChoice(const Subject& subject, const ChosenVariant* variant, const RunResult& result) {
  Choice choice;
  choice.tool_version = kToolVersion;
  choice.is_original = variant == nullptr;
  choice.reason = result.choice.reason;
  choice.scenario_file = fs::path(result.scenario.path).filename().string();
  choice.scenario_hash = subject.scenario.hash;
  choice.shader_hash = shaderHash(subject);
  choice.quality = result.quality;
  choice.limits = limitsOf(result);
  choice.least_gain = result.least_gain;
  choice.device = {result.device.name, result.device.driver, result.clock};
  if (variant == nullptr) return choice;
  choice.candidate_id = variant->candidate.id;
  choice.payload = identifyPayload(*subject.program.fragment, subject.program.analysis, variant->candidate);
  choice.variant = variant->options;
  choice.models = modelsOf(result);
  const RunChoice& measured = result.choice;
  choice.measured = {measured.measured_error, measured.measured_speedup, std::nullopt, std::nullopt, measured.measured_frame_ms, result.original.frame_ms};
  if (measured.speedup_ci95) {
    choice.measured.speedup_low = measured.speedup_ci95->lo;
    choice.measured.speedup_high = measured.speedup_ci95->hi;
  }
  return choice;
}

Result<ChosenVariant> variantOf(const Subject& subject, const Choice& choice) {
  REPRISE_TRY(expectMotion(subject));
  const ShaderProgram& program = subject.program;
  ChosenVariant variant;
  REPRISE_ASSIGN(variant.candidate, findPayload(*program.fragment, program.analysis, program.sources, choice.payload));
  variant.candidate.id = choice.candidate_id;
  variant.options = choice.variant;
  variant.options.orthographic = subject.orthographic;
  if (subject.scenario.stereo) variant.options.previous = PreviousImage::kOtherEye;
  return variant;
}

Result<Package> shippedPackage(const Subject& subject, const ChosenVariant* variant) {
  VariantOptions original = baseOptions(subject, {});
  original.strategy = "original";
  REPRISE_ASSIGN(Package package, variant == nullptr ? buildPackage(subject.program, {}, original, subject.limits)
                                                     : buildPackage(subject.program, variant->candidate, variant->options, subject.limits));
  package.tool_version = kToolVersion;
  REPRISE_TRY(relocate(folderOf(subject), package));
  return package;
}

std::vector<std::string> dependenciesOf(const Subject& subject) {
  const Scenario& scenario = subject.scenario;
  std::vector<std::string> files = {scenario.path, scenario.fragment_path, scenario.vertex_path};
  files.insert(files.end(), subject.included.begin(), subject.included.end());
  for (const TextureSpec& texture : scenario.textures)
    if (texture.kind == TextureKind::kFile) files.push_back(texture.path);
  for (const ModelSpec& model : scenario.models) {
    if (model.path.empty()) continue;
    files.push_back(model.path);
    for (const std::string& file : model.scene->files) files.push_back((fs::path(model.path).parent_path() / file).string());
  }
  std::vector<std::string> each;
  for (const std::string& file : files)
    if (!file.empty() && std::find(each.begin(), each.end(), file) == each.end()) each.push_back(file);
  return each;
}

}  // namespace reprise

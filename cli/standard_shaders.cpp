#include "cli/standard_shaders.h"

#include <algorithm>

#include "compiler/source/standard_vertex.h"
#include "cli/embedded_glsl.h"
#include "profiler/gltf/vertex.h"
#include "profiler/scenario/passes.h"

namespace reprise {
namespace {

constexpr std::size_t kMostLights = 16;

std::string embedded(const std::string& name) {
  for (const EmbeddedGlsl& file : kEmbeddedGlsl)
    if (name == file.name) return file.text;
  return {};
}

}  // namespace

Result<CompiledShader> standardFragment(const Scenario& scenario) {
  bool normal_map = false, mask = false, double_sided = false;
  const bool shadow = standardShadow(scenario).has_value();
  std::size_t lights = shadow ? 1 : 0;
  for (const ModelSpec& model : scenario.models) {
    for (const GltfMaterial& material : model.scene->materials) {
      normal_map = normal_map || material.normal_map.image >= 0;
      mask = mask || material.alpha_cutoff > 0;
      double_sided = double_sided || material.double_sided;
    }
    for (const int node : model.scene->order) lights += model.scene->nodes[static_cast<std::size_t>(node)].light >= 0;
  }
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  options.defines = scenario.defines;
  if (normal_map) options.defines.emplace_back("NORMAL_MAP", "1");
  if (mask) options.defines.emplace_back("ALPHA_MASK", "1");
  if (double_sided) options.defines.emplace_back("DOUBLE_SIDED", "1");
  if (shadow) options.defines.emplace_back("SHADOW_MAP", "1");
  if (lights > 0) options.defines.emplace_back("LIGHTS", std::to_string(std::min(lights, kMostLights)));
  return compileText(embedded("metallic_roughness.frag"), "metallic_roughness.frag", options);
}

Result<CompiledShader> standardVertex(const Scenario& scenario, const CompiledShader& fragment) {
  StandardVertexOptions needs;
  for (const ModelSpec& model : scenario.models) {
    for (const GltfInstance& instance : model.scene->instances) {
      needs.morph_targets = std::max(needs.morph_targets, primitiveOf(*model.scene, instance).targets.size());
      if (instance.skin >= 0) needs.joints = std::max(needs.joints, model.scene->skins[static_cast<std::size_t>(instance.skin)].joints.size());
    }
  }
  REPRISE_ASSIGN(const std::string text, standardVertexText(fragment.words, needs));
  CompileOptions options;
  options.stage = ShaderStage::kVertex;
  return compileText(text, "standard.vert", options);
}

}  // namespace reprise

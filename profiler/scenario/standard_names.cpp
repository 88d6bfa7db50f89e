#include "profiler/scenario/standard_names.h"

#include <algorithm>

#include "profiler/gltf/vertex.h"
#include "profiler/scenario/names.h"

namespace reprise {
namespace {

constexpr const char* kMaterialTextures[] = {"base_color_map", "metallic_roughness_map", "normal_map", "occlusion_map", "emissive_map"};

}  // namespace

std::optional<Semantic> standardSemantic(const std::string& member) {
  const std::size_t dot = member.find('.');
  if (!member.starts_with("Standard") || dot == std::string::npos) return std::nullopt;
  for (const auto& named : kSemantics)
    if (member.compare(dot + 1, std::string::npos, named.name) == 0) return named.value;
  return std::nullopt;
}

bool isMaterialTexture(const std::string& name) {
  return std::any_of(std::begin(kMaterialTextures), std::end(kMaterialTextures), [&](const char* known) { return name == known; });
}

bool isStandardTexture(const std::string& name) { return isMaterialTexture(name) || name == "environment_map"; }

TextureSpec defaultTexture(const std::string& name) {
  TextureSpec spec;
  spec.name = name;
  if (name == "environment_map") {
    spec.kind = TextureKind::kSky;
    spec.color_a = {0.35f, 0.55f, 0.95f, 1};
    spec.color_b = {0.75f, 0.8f, 0.85f, 1};
    return spec;
  }
  spec.size = 1;
  spec.cells = 1;
  spec.color_a = name == "normal_map" ? std::array<float, 4>{0.5f, 0.5f, 1, 1} : std::array<float, 4>{1, 1, 1, 1};
  return spec;
}

bool isModelSemantic(Semantic semantic) { return semantic >= Semantic::kJointMatrices; }

std::string modelSemanticMismatch(Semantic semantic, const BlockMember& member) {
  const bool is_float = member.scalar == ScalarKind::kFloat, single = member.array_length == 0;
  const bool vector = is_float && single && member.columns == 1;
  switch (semantic) {
    case Semantic::kJointMatrices:
      return is_float && !single && member.columns == 4 && member.rows == 4 ? "" : "an array of mat4";
    case Semantic::kMorphWeights:
    case Semantic::kBaseColorFactor:
    case Semantic::kMetallicRoughness:
    case Semantic::kEmissiveFactor:
      return vector && member.rows == 4 ? "" : "a vec4";
    case Semantic::kAlphaCutoff:
      return vector && member.rows == 1 ? "" : "a float";
    case Semantic::kJointCount:
    case Semantic::kLightCount:
      return single && member.columns == 1 && member.rows == 1 ? "" : "an int, uint or float";
    default:
      return is_float && !single && member.columns == 1 && member.rows == 4 ? "" : "an array of vec4";
  }
}

const std::vector<std::string>& deformInputs() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = {"joints", "weights"};
    for (const char* kind : {"morph_position_", "morph_normal_"})
      for (std::size_t target = 0; target < kMorphTargets; ++target) names.push_back(kind + std::to_string(target));
    return names;
  }();
  return kNames;
}

}  // namespace reprise

#include "profiler/scene/shared_inputs.h"

#include <algorithm>

#include "profiler/scenario/passes.h"
#include "profiler/scenario/standard_names.h"

namespace reprise {
namespace {

bool isOfObject(Semantic semantic) {
  return semantic == Semantic::kModel || semantic == Semantic::kNormalMatrix || isModelSemantic(semantic);
}

bool holdsObject(const Scenario& scenario, const std::string& block_name, const std::vector<BlockMember>& members) {
  return std::any_of(members.begin(), members.end(), [&](const BlockMember& member) {
    const std::string full_name = block_name + "." + member.name;
    if (const auto standard = standardSemantic(full_name); standard && isOfObject(*standard)) return true;
    return std::any_of(scenario.uniforms.begin(), scenario.uniforms.end(), [&](const UniformBinding& binding) {
      const auto* semantic = std::get_if<Semantic>(&binding.source);
      return binding.member == full_name && semantic != nullptr && isOfObject(*semantic);
    });
  });
}

bool isOfMaterial(const Scenario& scenario, const std::string& texture) {
  const bool given = std::any_of(scenario.textures.begin(), scenario.textures.end(), [&](const TextureSpec& spec) { return spec.name == texture; });
  return isMaterialTexture(texture) && !given && !findPassTexture(scenario, texture);
}

}  // namespace

bool drawsShareInputs(const Scenario& scenario, const ShaderInterface& interface) {
  if (scenario.objects.size() <= 1) return true;
  const bool own_constants = std::any_of(interface.push_constants.begin(), interface.push_constants.end(),
                                         [](const PushConstantRange& range) { return (range.stages & kStageFragment) != 0; });
  if (own_constants && holdsObject(scenario, interface.push_constant_name, interface.push_constant_members)) return false;
  return std::none_of(interface.descriptors.begin(), interface.descriptors.end(), [&](const Descriptor& descriptor) {
    if ((descriptor.stages & kStageFragment) == 0) return false;
    return holdsObject(scenario, descriptor.name, descriptor.members) || isOfMaterial(scenario, descriptor.name);
  });
}

}  // namespace reprise

#include "profiler/scenario/check_passes.h"

#include <algorithm>

#include "profiler/scenario/near_names.h"
#include "profiler/scenario/passes.h"
#include "profiler/scenario/standard_names.h"

namespace reprise {
namespace {

std::vector<std::string> sampledBy(const ShaderInterface& interface, std::uint32_t stages) {
  std::vector<std::string> names;
  for (const Descriptor& descriptor : interface.descriptors)
    if (descriptor.kind == DescriptorKind::kCombinedImageSampler && (descriptor.stages & stages) != 0) names.push_back(descriptor.name);
  return names;
}

// A pass reads what those before it have made: this is what rules out circles.
void checkOrder(const Scenario& scenario, std::size_t index, const std::vector<std::string>& sampled, Diagnostics& diagnostics) {
  const PassSpec& pass = scenario.passes[index];
  for (const std::string& name : sampled) {
    const auto made = findPassTexture(scenario, name);
    if (!made || made->pass < index) continue;
    const std::string by = made->pass == index ? "itself" : "the later pass '" + scenario.passes[made->pass].name + "'";
    diagnostics.add("pass_order", "pass '" + pass.name + "' samples '" + name + "', which is made by " + by + "; expected textures of passes before it", pass.place);
  }
}

void checkSampled(const PassSpec& pass, const std::vector<std::string>& sampled, Diagnostics& diagnostics) {
  for (const std::string& name : texturesOf(pass))
    if (std::find(sampled.begin(), sampled.end(), name) == sampled.end())
      diagnostics.add("unknown_texture", "no shader samples the texture '" + name + "' of pass '" + pass.name + "'" + suggestNames(name, sampled), pass.place);
}

void checkShadowUse(const Scenario& scenario, const ShaderInterface& interface, Diagnostics& diagnostics) {
  if (standardShadow(scenario)) return;
  const auto bound = std::find_if(scenario.uniforms.begin(), scenario.uniforms.end(), [](const UniformBinding& binding) {
    const auto* semantic = std::get_if<Semantic>(&binding.source);
    return semantic && *semantic == Semantic::kShadowViewProjection;
  });
  bool read = bound != scenario.uniforms.end();
  for (const Descriptor& descriptor : interface.descriptors)
    for (const BlockMember& member : descriptor.members)
      read = read || standardSemantic(descriptor.name + "." + member.name) == Semantic::kShadowViewProjection;
  if (read)
    diagnostics.add("value", "'shadow_view_projection' is that of a shadow pass named 'shadow_map', but there is none",
                    bound != scenario.uniforms.end() ? bound->place : scenario.uniforms_place);
}

}  // namespace

void checkPasses(const Scenario& scenario, const ShaderInterface& interface, std::span<const ShaderInterface> passes, Diagnostics& diagnostics) {
  constexpr std::uint32_t kAnyStage = kStageVertex | kStageFragment;
  std::vector<std::string> sampled = sampledBy(interface, kAnyStage);
  for (const ShaderInterface& pass : passes)
    for (const std::string& name : sampledBy(pass, kAnyStage)) sampled.push_back(name);
  for (std::size_t index = 0; index < scenario.passes.size(); ++index) {
    const PassSpec& pass = scenario.passes[index];
    checkSampled(pass, sampled, diagnostics);
    if (pass.kind == ScenePassKind::kShadow) {
      checkOrder(scenario, index, sampledBy(interface, kStageVertex), diagnostics);
    } else if (index < passes.size()) {
      checkOrder(scenario, index, sampledBy(passes[index], kAnyStage), diagnostics);
      if (passes[index].outputs.size() != pass.outputs.size())
        diagnostics.add("outputs", "the fragment shader of pass '" + pass.name + "' has " + std::to_string(passes[index].outputs.size()) +
                                       " colour outputs, but 'outputs' has " + std::to_string(pass.outputs.size()), pass.place);
    }
  }
  checkShadowUse(scenario, interface, diagnostics);
}

}  // namespace reprise

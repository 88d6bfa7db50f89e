#include "profiler/scenario/passes.h"

namespace reprise {

std::optional<PassTexture> findPassTexture(const Scenario& scenario, const std::string& name) {
  for (std::size_t index = 0; index < scenario.passes.size(); ++index) {
    const PassSpec& pass = scenario.passes[index];
    const std::string& depth = pass.kind == ScenePassKind::kShadow ? pass.name : pass.depth_texture;
    if (!depth.empty() && depth == name) return PassTexture{index, true, 0};
    for (std::size_t output = 0; output < pass.outputs.size(); ++output)
      if (pass.outputs[output].texture == name) return PassTexture{index, false, output};
  }
  return std::nullopt;
}

std::vector<std::string> texturesOf(const PassSpec& pass) {
  if (pass.kind == ScenePassKind::kShadow) return {pass.name};
  std::vector<std::string> names;
  for (const PassOutput& output : pass.outputs) names.push_back(output.texture);
  if (!pass.depth_texture.empty()) names.push_back(pass.depth_texture);
  return names;
}

std::optional<std::size_t> findPass(const Scenario& scenario, const std::string& name) {
  for (std::size_t index = 0; index < scenario.passes.size(); ++index)
    if (scenario.passes[index].name == name) return index;
  return std::nullopt;
}

std::optional<std::size_t> standardShadow(const Scenario& scenario) {
  const auto index = findPass(scenario, "shadow_map");
  return index && scenario.passes[*index].kind == ScenePassKind::kShadow ? index : std::nullopt;
}

}  // namespace reprise

#include "profiler/scene/model_values.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "profiler/scenario/passes.h"

namespace reprise {
namespace {

constexpr float kNoCone = -2;

GltfMaterial materialOf(const Scenario& scenario, const Object& object) {
  if (!object.part) {
    GltfMaterial plain;
    plain.metallic = 0;
    plain.roughness = 0.5f;
    return plain;
  }
  const ModelSpec& model = scenario.models[object.part->model];
  const int material = primitiveOf(*model.scene, model.scene->instances[object.part->instance]).material;
  GltfMaterial result = material >= 0 ? model.scene->materials[static_cast<std::size_t>(material)] : GltfMaterial{};
  for (std::size_t i = 0; i < 4; ++i) result.base_color[i] *= model.color[i];
  return result;
}

std::vector<float> jointValues(const std::vector<glm::mat4>& joints) {
  std::vector<float> values;
  for (const glm::mat4& joint : joints)
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) values.push_back(joint[column][row]);
  return values;
}

struct PlacedLight {
  glm::vec4 position, color, direction;
};

// The light of a shadow pass shines from where the pass looks from: a sun where it is orthographic, else a spot.
PlacedLight lightOfPass(const PassSpec& pass, const PassView& view) {
  const glm::vec3 ahead = -glm::vec3(view.view[0][2], view.view[1][2], view.view[2][2]);
  PlacedLight light;
  light.position = pass.light.orthographic ? glm::vec4(-ahead, 0) : glm::vec4(view.position, 1);
  light.color = {pass.color[0], pass.color[1], pass.color[2], 0};
  light.direction = {ahead, pass.light.orthographic ? kNoCone : std::cos(glm::radians(pass.light.fov_y_deg) / 2)};
  return light;
}

std::vector<PlacedLight> lightsOf(const Scenario& scenario, const FrameState& state) {
  std::vector<PlacedLight> lights;
  if (const auto shadow = standardShadow(scenario); shadow && *shadow < state.pass_views.size())
    lights.push_back(lightOfPass(scenario.passes[*shadow], state.pass_views[*shadow]));
  for (std::size_t m = 0; m < scenario.models.size(); ++m) {
    const GltfScene& scene = *scenario.models[m].scene;
    for (const int index : scene.order) {
      const GltfNode& node = scene.nodes[static_cast<std::size_t>(index)];
      if (node.light < 0) continue;
      const GltfLight& light = scene.lights[static_cast<std::size_t>(node.light)];
      const glm::mat4 place = state.placements[m] * state.poses[m].nodes[static_cast<std::size_t>(index)];
      const glm::vec3 ahead = -glm::vec3(place[2]) / std::max(glm::length(glm::vec3(place[2])), 1e-20f);
      PlacedLight placed;
      placed.position = light.kind == GltfLightKind::kDirectional ? glm::vec4(-ahead, 0) : glm::vec4(glm::vec3(place[3]), 1);
      placed.color = {light.color[0], light.color[1], light.color[2], light.range};
      placed.direction = {ahead, light.kind == GltfLightKind::kSpot ? std::cos(light.outer_cone_rad) : kNoCone};
      lights.push_back(placed);
    }
  }
  return lights;
}

std::vector<float> lightValues(const std::vector<PlacedLight>& lights, glm::vec4 PlacedLight::*part) {
  std::vector<float> values;
  for (const PlacedLight& light : lights)
    for (int i = 0; i < 4; ++i) values.push_back((light.*part)[i]);
  return values;
}

}  // namespace

std::vector<float> modelValues(Semantic semantic, const Scenario& scenario, const FrameState& state, std::size_t object) {
  const Object& drawn = scenario.objects[object];
  const ModelSpec* model = drawn.part ? &scenario.models[drawn.part->model] : nullptr;
  const GltfInstance* instance = model ? &model->scene->instances[drawn.part->instance] : nullptr;
  const bool skinned = instance && instance->skin >= 0 && !primitiveOf(*model->scene, *instance).deform.empty();
  const GltfMaterial material = materialOf(scenario, drawn);
  switch (semantic) {
    case Semantic::kJointMatrices:
      return skinned ? jointValues(state.poses[drawn.part->model].joints[static_cast<std::size_t>(instance->skin)]) : std::vector<float>{};
    case Semantic::kJointCount:
      return {skinned ? static_cast<float>(model->scene->skins[static_cast<std::size_t>(instance->skin)].joints.size()) : 0.0f};
    case Semantic::kMorphWeights: {
      if (!instance) return {};
      const auto weights = keptWeights(*model->scene, state.poses[drawn.part->model], *instance);
      return {weights.begin(), weights.end()};
    }
    case Semantic::kBaseColorFactor: return {material.base_color.begin(), material.base_color.end()};
    case Semantic::kMetallicRoughness: return {material.metallic, material.roughness, material.normal_scale, material.occlusion_strength};
    case Semantic::kEmissiveFactor: return {material.emissive[0], material.emissive[1], material.emissive[2], 0};
    case Semantic::kAlphaCutoff: return {material.alpha_cutoff};
    case Semantic::kLightPosition: return lightValues(lightsOf(scenario, state), &PlacedLight::position);
    case Semantic::kLightColor: return lightValues(lightsOf(scenario, state), &PlacedLight::color);
    case Semantic::kLightDirection: return lightValues(lightsOf(scenario, state), &PlacedLight::direction);
    case Semantic::kLightCount: return {static_cast<float>(lightsOf(scenario, state).size())};
    default: return {};
  }
}

}  // namespace reprise

#include "profiler/session/model_textures.h"

#include <algorithm>
#include <tuple>

#include "profiler/scenario/passes.h"
#include "profiler/scenario/standard_names.h"

namespace reprise {
namespace {

GltfTexture textureOf(const GltfMaterial& material, const std::string& name) {
  if (name == "base_color_map") return material.base_color_map;
  if (name == "metallic_roughness_map") return material.metallic_roughness_map;
  if (name == "normal_map") return material.normal_map;
  if (name == "occlusion_map") return material.occlusion_map;
  return material.emissive_map;
}

ModelTexture chosen(const Scenario& scenario, const Object& object, const std::string& name) {
  ModelTexture result{defaultTexture(name), nullptr};
  if (!object.part || !isMaterialTexture(name)) return result;
  const ModelSpec& model = scenario.models[object.part->model];
  const GltfScene& scene = *model.scene;
  const int material = primitiveOf(scene, scene.instances[object.part->instance]).material;
  if (material < 0) return result;
  const GltfTexture texture = textureOf(scene.materials[static_cast<std::size_t>(material)], name);
  if (texture.image < 0) return result;
  result.image = &scene.images[static_cast<std::size_t>(texture.image)];
  result.spec.kind = TextureKind::kFile;
  result.spec.name = result.image->name;
  result.spec.path = model.path + ": " + result.image->name;
  result.spec.linear = texture.linear;
  result.spec.repeat = texture.repeat;
  result.spec.srgb = name == "base_color_map" || name == "emissive_map";
  result.spec.place = model.place;
  result.spec.file_place = {model.path, 0, 0};
  return result;
}

}  // namespace

ModelTextures listModelTextures(const Scenario& scenario, const ShaderInterface& interface) {
  ModelTextures result;
  std::map<std::tuple<const GltfImage*, std::string, bool, bool, bool>, std::size_t> known;
  for (const Descriptor& descriptor : interface.descriptors) {
    if (descriptor.kind != DescriptorKind::kCombinedImageSampler || !isStandardTexture(descriptor.name)) continue;
    const bool given = std::any_of(scenario.textures.begin(), scenario.textures.end(), [&](const TextureSpec& spec) { return spec.name == descriptor.name; });
    if (given || findPassTexture(scenario, descriptor.name)) continue;
    for (const Object& object : scenario.objects) {
      ModelTexture texture = chosen(scenario, object, descriptor.name);
      const auto key = std::make_tuple(texture.image, texture.image ? std::string() : descriptor.name, texture.spec.linear, texture.spec.repeat, texture.spec.srgb);
      const auto [place, fresh] = known.try_emplace(key, result.textures.size());
      if (fresh) result.textures.push_back(std::move(texture));
      result.used[descriptor.name].push_back(place->second);
    }
  }
  return result;
}

}  // namespace reprise

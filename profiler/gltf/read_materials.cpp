#include <tiny_gltf.h>

#include <cmath>

#include "profiler/gltf/gltf_parts.h"
#include "profiler/gltf/undrawn_extensions.h"

namespace reprise {
namespace {

struct TextureUse {
  int index, tex_coord;
};

Result<GltfTexture> textureOf(const tinygltf::Model& model, const TextureUse& use, const std::string& where, GltfScene& scene) {
  GltfTexture result;
  if (use.index < 0) return result;
  REPRISE_TRY(expectIndex(use.index, model.textures.size(), where + ".index"));
  if (use.tex_coord != 0) scene.warnings.push_back(where + ": TEXCOORD_" + std::to_string(use.tex_coord) + " is not read, TEXCOORD_0 stands in");
  const tinygltf::Texture& texture = model.textures[static_cast<std::size_t>(use.index)];
  const std::string place = elementPath("textures", static_cast<std::size_t>(use.index));
  if (texture.source < 0) {
    scene.warnings.push_back(place + ": it has no source, and is taken as absent");
    return result;
  }
  REPRISE_TRY(expectIndex(texture.source, model.images.size(), place + ".source"));
  result.image = texture.source;
  if (texture.sampler < 0) return result;
  REPRISE_TRY(expectIndex(texture.sampler, model.samplers.size(), place + ".sampler"));
  const tinygltf::Sampler& sampler = model.samplers[static_cast<std::size_t>(texture.sampler)];
  result.linear = sampler.magFilter != TINYGLTF_TEXTURE_FILTER_NEAREST;
  result.repeat = sampler.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
  return result;
}

Result<void> readFactors(const tinygltf::Material& from, const std::string& where, GltfMaterial& material) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  if (pbr.baseColorFactor.size() != 4) return gltfError("value", where + ".pbrMetallicRoughness.baseColorFactor", "expected 4 numbers");
  for (std::size_t i = 0; i < 4; ++i) material.base_color[i] = static_cast<float>(pbr.baseColorFactor[i]);
  for (std::size_t i = 0; i < 3 && i < from.emissiveFactor.size(); ++i) material.emissive[i] = static_cast<float>(from.emissiveFactor[i]);
  material.metallic = static_cast<float>(pbr.metallicFactor);
  material.roughness = static_cast<float>(pbr.roughnessFactor);
  material.normal_scale = static_cast<float>(from.normalTexture.scale);
  material.occlusion_strength = static_cast<float>(from.occlusionTexture.strength);
  material.alpha_cutoff = from.alphaMode == "MASK" ? static_cast<float>(from.alphaCutoff) : 0;
  material.double_sided = from.doubleSided;
  float sum = material.metallic + material.roughness + material.normal_scale + material.occlusion_strength + material.alpha_cutoff;
  for (const float value : material.base_color) sum += value;
  for (const float value : material.emissive) sum += value;
  if (!std::isfinite(sum)) return gltfError("value", where, "a factor is not finite");
  return {};
}

Result<void> readImages(const tinygltf::Model& model, GltfScene& scene) {
  for (std::size_t i = 0; i < model.images.size(); ++i) {
    const tinygltf::Image& from = model.images[i];
    GltfImage image{elementPath("images", i), std::string(from.image.begin(), from.image.end())};
    if (!from.uri.empty() && !from.uri.starts_with("data:")) image.name += " ('" + from.uri + "')";
    if (from.bufferView >= 0) {
      REPRISE_ASSIGN(const ByteRange range, viewBytes(model, from.bufferView, image.name));
      image.bytes.assign(reinterpret_cast<const char*>(range.data), range.size);
    }
    scene.images.push_back(std::move(image));
  }
  return {};
}

}  // namespace

Result<void> readMaterials(const tinygltf::Model& model, GltfScene& scene) {
  REPRISE_TRY(readImages(model, scene));
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const tinygltf::Material& from = model.materials[i];
    const std::string where = elementPath("materials", i);
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    GltfMaterial material;
    REPRISE_TRY(readFactors(from, where, material));
    const std::string named = from.name.empty() ? where : where + " '" + from.name + "'";
    for (std::string& warning : undrawnExtensions(from, named)) scene.warnings.push_back(std::move(warning));
    if (from.alphaMode == "BLEND") scene.warnings.push_back(named + ": blending is not done, the material is drawn opaque");
    const auto map = [&](GltfTexture& texture, const TextureUse& use, const std::string& name) -> Result<void> {
      REPRISE_ASSIGN(texture, textureOf(model, use, where + "." + name, scene));
      return {};
    };
    REPRISE_TRY(map(material.base_color_map, {pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord}, "pbrMetallicRoughness.baseColorTexture"));
    REPRISE_TRY(map(material.metallic_roughness_map, {pbr.metallicRoughnessTexture.index, pbr.metallicRoughnessTexture.texCoord},
                    "pbrMetallicRoughness.metallicRoughnessTexture"));
    REPRISE_TRY(map(material.normal_map, {from.normalTexture.index, from.normalTexture.texCoord}, "normalTexture"));
    REPRISE_TRY(map(material.occlusion_map, {from.occlusionTexture.index, from.occlusionTexture.texCoord}, "occlusionTexture"));
    REPRISE_TRY(map(material.emissive_map, {from.emissiveTexture.index, from.emissiveTexture.texCoord}, "emissiveTexture"));
    scene.materials.push_back(material);
  }
  return {};
}

}  // namespace reprise

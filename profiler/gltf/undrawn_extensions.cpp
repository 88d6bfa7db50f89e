#include "profiler/gltf/undrawn_extensions.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <iterator>

namespace reprise {
namespace {

// Extensions that a number turns off; it is also what the number is where the file does not say.
struct Strength {
  const char* extension;
  const char* key;
  double neutral;
};
constexpr Strength kStrengths[] = {{"KHR_materials_anisotropy", "anisotropyStrength", 0},
                                   {"KHR_materials_clearcoat", "clearcoatFactor", 0},
                                   {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0},
                                   {"KHR_materials_dispersion", "dispersion", 0},
                                   {"KHR_materials_emissive_strength", "emissiveStrength", 1},
                                   {"KHR_materials_ior", "ior", 1.5},
                                   {"KHR_materials_iridescence", "iridescenceFactor", 0},
                                   {"KHR_materials_transmission", "transmissionFactor", 0},
                                   {"KHR_materials_volume", "thicknessFactor", 0}};

bool changesNothing(const std::string& name, const tinygltf::Value& value) {
  const auto strength = std::find_if(std::begin(kStrengths), std::end(kStrengths), [&](const Strength& one) { return name == one.extension; });
  if (strength == std::end(kStrengths)) return false;
  if (!value.IsObject() || !value.Has(strength->key)) return true;
  const tinygltf::Value& number = value.Get(strength->key);
  return number.IsNumber() && number.GetNumberAsDouble() == strength->neutral;
}

void warnOf(const tinygltf::ExtensionMap& extensions, const std::string& where, std::vector<std::string>& warnings) {
  for (const auto& [name, value] : extensions)
    if (!changesNothing(name, value)) warnings.push_back(where + ": " + name + " is not drawn");
}

}  // namespace

std::vector<std::string> undrawnExtensions(const tinygltf::Material& material, const std::string& where) {
  std::vector<std::string> warnings;
  warnOf(material.extensions, where, warnings);
  const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  warnOf(pbr.baseColorTexture.extensions, where + ".pbrMetallicRoughness.baseColorTexture", warnings);
  warnOf(pbr.metallicRoughnessTexture.extensions, where + ".pbrMetallicRoughness.metallicRoughnessTexture", warnings);
  warnOf(material.normalTexture.extensions, where + ".normalTexture", warnings);
  warnOf(material.occlusionTexture.extensions, where + ".occlusionTexture", warnings);
  warnOf(material.emissiveTexture.extensions, where + ".emissiveTexture", warnings);
  return warnings;
}

}  // namespace reprise

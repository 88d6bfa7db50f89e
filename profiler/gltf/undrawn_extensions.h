// Extensions of a glTF file that change how a material looks and are not drawn here: all of them.
#pragma once

#include <string>
#include <vector>

namespace tinygltf {
struct Material;
}  // namespace tinygltf

namespace reprise {

// One warning for each extension of the material and of its textures that changes something. `where` names the material.
std::vector<std::string> undrawnExtensions(const tinygltf::Material& material, const std::string& where);

}  // namespace reprise

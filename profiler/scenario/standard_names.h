// What is bound by name alone, without a line in the scenario: the members of uniform blocks that are called Standard...,
// and the textures of glTF's materials.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

// "StandardObject.model" is Semantic::kModel: the block's name begins with "Standard" and the member is named like a source.
std::optional<Semantic> standardSemantic(const std::string& member);

// base_color_map, metallic_roughness_map, normal_map, occlusion_map, emissive_map: each object's own, one texel where it has none.
// environment_map: a sky, latitude and longitude. A [[texture]] of that name takes their place.
bool isMaterialTexture(const std::string& name);
bool isStandardTexture(const std::string& name);
TextureSpec defaultTexture(const std::string& name);

// Sources that models fill (kJointMatrices and what follows).
bool isModelSemantic(Semantic semantic);

// Which members such a source can fill, in words; empty if this one can be.
std::string modelSemanticMismatch(Semantic semantic, const BlockMember& member);

// "joints", "weights", "morph_position_0", ...: vertex inputs of skinned and morphed meshes; zero of others.
const std::vector<std::string>& deformInputs();

}  // namespace reprise

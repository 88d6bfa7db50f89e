// The textures of models' materials on a device: for each object its own, one texel where the material has none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "profiler/scenario/scenario.h"
#include "runtime/package/interface.h"

namespace reprise {

// One image of a scene, or a made-up one: what is to be uploaded, with the sampler's settings in its spec.
struct ModelTexture {
  TextureSpec spec;
  const GltfImage* image = nullptr;  // null: as the spec says
};

// By descriptor name, then object: index into `textures`.
struct ModelTextures {
  std::vector<ModelTexture> textures;
  std::map<std::string, std::vector<std::size_t>> used;
};

// For the standard textures of the interface that the scenario does not give itself. Equal ones are listed once.
ModelTextures listModelTextures(const Scenario& scenario, const ShaderInterface& interface);

}  // namespace reprise

// The passes of a scenario by what they make: textures that the shader and later passes sample by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "profiler/scenario/scenario.h"

namespace reprise {

struct PassTexture {
  std::size_t pass = 0;
  bool depth = false;      // the depth of the pass, else its colour output
  std::size_t output = 0;
};

std::optional<PassTexture> findPassTexture(const Scenario& scenario, const std::string& name);

// The names of all textures that a pass makes.
std::vector<std::string> texturesOf(const PassSpec& pass);

std::optional<std::size_t> findPass(const Scenario& scenario, const std::string& name);

// The shadow pass that the standard shaders know, named "shadow_map": its light is the first of light_position, light_color, ...
std::optional<std::size_t> standardShadow(const Scenario& scenario);

}  // namespace reprise

// A scenario for a model that comes alone: an orbiting camera fitted to its bounds, standard shaders.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/base/result.h"

namespace reprise {

// .gltf and .glb, in any case.
bool isModelFile(const std::filesystem::path& path);

// TOML of the scenario: training sessions "orbit" and "approach", validation sessions "other_orbit" and "walk". Distances are in units of
// the radius of the box about the model over its first animation. Errors: those of readGltf.
Result<std::string> modelScenario(const std::filesystem::path& model);

}  // namespace reprise

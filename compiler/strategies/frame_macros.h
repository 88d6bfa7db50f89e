// What the frames (compiler/strategies/glsl) are compiled with: the cache's layout, constants and the refresh pattern as macros.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/strategies/build_recipe.h"

namespace reprise {

using FrameMacros = std::map<std::string, std::string>;

struct FrameMacroSource {
  const ShaderProgram& program;
  const VariantOptions& options;
  const CacheLayout& layout;
  const CacheConstants& constants;
  const std::vector<int>& guards;  // channels that hold 1 where a guarded value was computed
  PayloadScalar scalar;
  bool keeps_raw_payload;
  std::uint32_t reprise_set;  // descriptor set of the frame's own inputs
};

// Locations are those of a pass with no other outputs, and every pass stores; what differs from pass to pass is overwritten by its builder.
FrameMacros frameMacros(const FrameMacroSource& source);

}  // namespace reprise

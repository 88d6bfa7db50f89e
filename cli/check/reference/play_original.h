// A module played as it stands: one pass, the module's own words, no variant.
#pragma once

#include <cstdint>
#include <vector>

#include "profiler/harness/harness.h"

namespace reprise {

struct PlayedModule {
  const ShaderInterface& interface;
  const std::vector<std::uint32_t>& vertex_words;
  const std::vector<std::uint32_t>& fragment_words;
};

Package originalPackage(const PlayedModule& module);

// Frames 0 .. frames - 1 under motion. The player was made by a harness of the same interface, with whatever inputs. Errors: those of Harness.
Result<std::vector<HarnessFrame>> playFrames(Harness& harness, Player& player, int frames);
Result<std::vector<HarnessFrame>> playOriginal(Harness& harness, const PlayedModule& module, int frames);

}  // namespace reprise

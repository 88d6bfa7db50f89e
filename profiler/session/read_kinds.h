// What the counting copy of a variant tells of each pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/playback/player.h"
#include "runtime/vulkan/readback.h"

namespace reprise {

struct PixelKinds {
  std::vector<std::uint8_t> kind;  // 0 uncovered, 1 hit, 2 miss
  std::vector<std::uint8_t> age;   // VariantOptions::aged; 0 where uncovered; empty where the copy tells of none
};

bool tellsKinds(const Recipe& recipe);

// Of the last recorded frame; empty where the recipe does not tell kinds. Errors: those of Readback::read.
Result<PixelKinds> readKinds(Readback& readback, Commands& commands, const Player& player);

}  // namespace reprise

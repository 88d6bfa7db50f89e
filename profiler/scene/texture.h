// Textures from files or generators, as RGBA with 32-bit floats, rows from the top.
#pragma once

#include <vector>

#include "profiler/scenario/scenario.h"
#include "runtime/base/result.h"

namespace reprise {

struct TextureImage {
  int width = 0, height = 0;
  bool high_dynamic_range = false;  // stored as RGBA32F, else as RGBA8
  std::vector<float> rgba;          // width * height * 4
};

// Errors (kInput): texture.missing, texture.format (not a PNG, JPEG or HDR that can be decoded).
Result<TextureImage> buildTexture(const TextureSpec& spec);

}  // namespace reprise

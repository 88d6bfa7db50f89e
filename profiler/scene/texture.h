// Textures from files or generators, as RGBA with 32-bit floats, rows from the top.
//
// Values are as stored: those of PNG and JPEG files lie in [0, 1] and are not decoded where `srgb` is set (the image format
// of the renderer does that). checker, noise and gradient mix color_a and color_b; noise repeats without a seam, and so do bumps, the normal map
// of such noise. sky is a
// map of latitude and longitude with a sun and has a high dynamic range, as HDR files have.
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

// All kinds but discs (disc_texture.h). Errors (kInput): those of readTextureFile, texture.format (not a PNG, JPEG or HDR that can be decoded).
Result<TextureImage> buildTexture(const TextureSpec& spec);

// The same from the bytes of a PNG, JPEG or HDR file; spec names them in messages.
Result<TextureImage> decodeTexture(const TextureSpec& spec, const std::string& content);

}  // namespace reprise

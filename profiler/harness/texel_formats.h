// Formats of made-up images and how a texel of each is put into bytes.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "runtime/package/interface.h"

namespace reprise {

struct TexelFormat {
  const char* name;    // GLSL's
  VkFormat format;
  std::size_t channels;
  std::size_t bytes;   // of a texel
  enum Coding { kFloat32, kFloat16, kUnorm, kSnorm, kWhole, kPacked } coding;
};

// Of a storage image; none for what GLSL has no name for.
std::optional<TexelFormat> texelFormatNamed(const std::string& name);

// Of a sampled image: 32 bits a channel; depth for images that are compared.
TexelFormat sampledFormat(ScalarKind texel, bool compares);

struct Texel {
  float values[4];           // of float and normalized formats, about [0, 1]
  std::uint32_t wholes[4];   // of integer formats
};

// to: of format.bytes bytes.
void encodeTexel(const TexelFormat& format, const Texel& texel, std::span<std::byte> to);

}  // namespace reprise

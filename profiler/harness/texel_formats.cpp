#include "profiler/harness/texel_formats.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace reprise {
namespace {

using Coding = TexelFormat::Coding;

constexpr TexelFormat kFormats[] = {
    {"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT, 4, 16, Coding::kFloat32}, {"rg32f", VK_FORMAT_R32G32_SFLOAT, 2, 8, Coding::kFloat32},
    {"r32f", VK_FORMAT_R32_SFLOAT, 1, 4, Coding::kFloat32}, {"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 4, 8, Coding::kFloat16},
    {"rg16f", VK_FORMAT_R16G16_SFLOAT, 2, 4, Coding::kFloat16}, {"r16f", VK_FORMAT_R16_SFLOAT, 1, 2, Coding::kFloat16},
    {"r11f_g11f_b10f", VK_FORMAT_B10G11R11_UFLOAT_PACK32, 3, 4, Coding::kPacked},
    {"rgb10_a2", VK_FORMAT_A2B10G10R10_UNORM_PACK32, 4, 4, Coding::kPacked},
    {"rgb10_a2ui", VK_FORMAT_A2B10G10R10_UINT_PACK32, 4, 4, Coding::kPacked},
    {"rgba16", VK_FORMAT_R16G16B16A16_UNORM, 4, 8, Coding::kUnorm}, {"rg16", VK_FORMAT_R16G16_UNORM, 2, 4, Coding::kUnorm},
    {"r16", VK_FORMAT_R16_UNORM, 1, 2, Coding::kUnorm}, {"rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4, 4, Coding::kUnorm},
    {"rg8", VK_FORMAT_R8G8_UNORM, 2, 2, Coding::kUnorm}, {"r8", VK_FORMAT_R8_UNORM, 1, 1, Coding::kUnorm},
    {"rgba16_snorm", VK_FORMAT_R16G16B16A16_SNORM, 4, 8, Coding::kSnorm}, {"rg16_snorm", VK_FORMAT_R16G16_SNORM, 2, 4, Coding::kSnorm},
    {"r16_snorm", VK_FORMAT_R16_SNORM, 1, 2, Coding::kSnorm}, {"rgba8_snorm", VK_FORMAT_R8G8B8A8_SNORM, 4, 4, Coding::kSnorm},
    {"rg8_snorm", VK_FORMAT_R8G8_SNORM, 2, 2, Coding::kSnorm}, {"r8_snorm", VK_FORMAT_R8_SNORM, 1, 1, Coding::kSnorm},
    {"rgba32i", VK_FORMAT_R32G32B32A32_SINT, 4, 16, Coding::kWhole}, {"rg32i", VK_FORMAT_R32G32_SINT, 2, 8, Coding::kWhole},
    {"r32i", VK_FORMAT_R32_SINT, 1, 4, Coding::kWhole}, {"rgba16i", VK_FORMAT_R16G16B16A16_SINT, 4, 8, Coding::kWhole},
    {"rg16i", VK_FORMAT_R16G16_SINT, 2, 4, Coding::kWhole}, {"r16i", VK_FORMAT_R16_SINT, 1, 2, Coding::kWhole},
    {"rgba8i", VK_FORMAT_R8G8B8A8_SINT, 4, 4, Coding::kWhole}, {"rg8i", VK_FORMAT_R8G8_SINT, 2, 2, Coding::kWhole},
    {"r8i", VK_FORMAT_R8_SINT, 1, 1, Coding::kWhole}, {"rgba32ui", VK_FORMAT_R32G32B32A32_UINT, 4, 16, Coding::kWhole},
    {"rg32ui", VK_FORMAT_R32G32_UINT, 2, 8, Coding::kWhole}, {"r32ui", VK_FORMAT_R32_UINT, 1, 4, Coding::kWhole},
    {"rgba16ui", VK_FORMAT_R16G16B16A16_UINT, 4, 8, Coding::kWhole}, {"rg16ui", VK_FORMAT_R16G16_UINT, 2, 4, Coding::kWhole},
    {"r16ui", VK_FORMAT_R16_UINT, 1, 2, Coding::kWhole}, {"rgba8ui", VK_FORMAT_R8G8B8A8_UINT, 4, 4, Coding::kWhole},
    {"rg8ui", VK_FORMAT_R8G8_UINT, 2, 2, Coding::kWhole}, {"r8ui", VK_FORMAT_R8_UINT, 1, 1, Coding::kWhole}};

constexpr TexelFormat kDepth = {"", VK_FORMAT_D32_SFLOAT, 1, 4, Coding::kFloat32};

std::uint32_t packed(const TexelFormat& format, const Texel& texel) {
  const float* v = texel.values;
  if (format.format == VK_FORMAT_B10G11R11_UFLOAT_PACK32) return glm::packF2x11_1x10(glm::vec3(v[0], v[1], v[2]));
  if (format.format == VK_FORMAT_A2B10G10R10_UNORM_PACK32) return glm::packUnorm3x10_1x2(glm::vec4(v[0], v[1], v[2], v[3]));
  const std::uint32_t* w = texel.wholes;
  return (w[0] & 1023u) | (w[1] & 1023u) << 10 | (w[2] & 1023u) << 20 | (w[3] & 3u) << 30;
}

// The bits of one channel, the lowest ones counting.
std::uint32_t channelBits(const TexelFormat& format, float value, std::uint32_t whole) {
  const std::size_t bits = format.bytes / format.channels * 8;
  std::uint32_t result = whole;
  switch (format.coding) {
    case Coding::kFloat32: std::memcpy(&result, &value, 4); break;
    case Coding::kFloat16: result = glm::packHalf1x16(value); break;
    case Coding::kUnorm: result = static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * static_cast<float>((1u << bits) - 1))); break;
    case Coding::kSnorm:
      result = static_cast<std::uint32_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * static_cast<float>((1u << (bits - 1)) - 1)));
      break;
    case Coding::kWhole:
    case Coding::kPacked: break;
  }
  return result;
}

}  // namespace

std::optional<TexelFormat> texelFormatNamed(const std::string& name) {
  for (const TexelFormat& format : kFormats)
    if (name == format.name) return format;
  return std::nullopt;
}

TexelFormat sampledFormat(ScalarKind texel, bool compares) {
  if (compares) return kDepth;
  return *texelFormatNamed(texel == ScalarKind::kFloat ? "rgba32f" : texel == ScalarKind::kInt ? "rgba32i" : "rgba32ui");
}

void encodeTexel(const TexelFormat& format, const Texel& texel, std::span<std::byte> to) {
  if (format.coding == Coding::kPacked) {
    const std::uint32_t word = packed(format, texel);
    std::memcpy(to.data(), &word, 4);
    return;
  }
  // Little-endian, as every device that Vulkan runs on.
  const std::size_t size = format.bytes / format.channels;
  for (std::size_t channel = 0; channel < format.channels; ++channel) {
    const std::uint32_t bits = channelBits(format, texel.values[channel], texel.wholes[channel]);
    std::memcpy(&to[channel * size], &bits, size);
  }
}

}  // namespace reprise

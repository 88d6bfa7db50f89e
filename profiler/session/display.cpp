#include "profiler/session/display.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/check.h"
#include "runtime/vulkan/readback.h"

namespace reprise {
namespace {

// Bytes have 256 values: a table spares a million tone maps per image.
void bytesToDisplay(std::span<const std::byte> texels, const DisplayMapping& mapping, DisplayImage& image) {
  std::array<float, 256> table;
  for (std::size_t value = 0; value < table.size(); ++value)
    table[value] = toneMapped(static_cast<float>(value) / 255.0f, mapping);
  const std::size_t pixels = texels.size() / 4;
  const std::byte* from = texels.data();
  float* to = image.rgb.data();
  for (std::size_t pixel = 0; pixel < pixels; ++pixel, from += 4, to += 3)
    for (std::size_t channel = 0; channel < 3; ++channel) to[channel] = table[std::to_integer<std::size_t>(from[channel])];
}

}  // namespace

float toneMapped(float value, const DisplayMapping& mapping) {
  const float x = value * mapping.exposure;
  float mapped = x;
  if (mapping.tone_map == ToneMap::kReinhard) mapped = x > 0 ? x / (1 + x) : 0;
  if (mapping.tone_map == ToneMap::kAces) mapped = x > 0 ? x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f) : 0;
  return std::clamp(mapped, 0.0f, 1.0f);
}

void toDisplay(std::span<const std::byte> texels, VkFormat format, const DisplayMapping& mapping, DisplayImage& image,
               std::vector<std::uint8_t>* nonfinite) {
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  REPRISE_CHECK(texels.size() == pixels * formatBytes(format), texels.size(), pixels);
  image.rgb.resize(pixels * 3);
  if (nonfinite != nullptr) nonfinite->assign(pixels, 0);
  if (format == VK_FORMAT_R8G8B8A8_UNORM) return bytesToDisplay(texels, mapping, image);
  const std::vector<float> rgba = toFloats(texels, format);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const float* texel = &rgba[pixel * 4];
    const bool finite = std::all_of(texel, texel + 4, [](float value) { return std::isfinite(value); });
    if (!finite && nonfinite != nullptr) (*nonfinite)[pixel] = 1;
    for (std::size_t channel = 0; channel < 3; ++channel)
      image.rgb[pixel * 3 + channel] = finite ? toneMapped(texel[channel], mapping) : 0.0f;
  }
}

}  // namespace reprise

// Colours as they reach a display, from what a render target holds.
//
// display = clamp(tone_map(exposure * x), 0, 1), channel by channel. Tone maps: none, x; Reinhard, x / (1 + x) (Reinhard et al.
// 2002, equation 3); ACES, x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) (Narkowicz' fit). Targets hold values as displayed: no
// transfer function is applied.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "profiler/metrics/image.h"
#include "profiler/scenario/scenario.h"

namespace reprise {

struct DisplayMapping {
  ToneMap tone_map = ToneMap::kNone;
  float exposure = 1;
};

float toneMapped(float value, const DisplayMapping& mapping);

// texels: image.width * image.height of `format` (one that can be read back), rows from the top. A pixel with a NaN or an
// infinity in any channel becomes black and is marked 1 in `nonfinite`, which gets one byte per pixel; it may be null.
void toDisplay(std::span<const std::byte> texels, VkFormat format, const DisplayMapping& mapping, DisplayImage& image,
               std::vector<std::uint8_t>* nonfinite);

}  // namespace reprise

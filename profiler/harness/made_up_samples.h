// Texels of made-up images, and images whose texels have several samples.
#pragma once

#include "profiler/harness/made_up_values.h"
#include "profiler/harness/texel_formats.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"

namespace reprise {

// Smooth in x and y with noise on top, so that filtering and its coordinates both show; in the ranges of the seed's style.
Texel madeUpTexel(std::uint32_t x, std::uint32_t y, float phase, std::size_t channels, MadeUpValues& values);

// A 2D image or array of four samples, in the layout for sampling; the samples of a texel are equal. Errors: harness.unsupported
// (kInput) for storage images, device.*.
Result<Image> madeUpSamples(const Context& context, Commands& commands, const Descriptor& descriptor, const TexelFormat& format,
                            MadeUpValues& values);

// A barrier between everything before and after.
void changeWholeLayout(const DeviceView& device, VkCommandBuffer commands, const Image& image, VkImageAspectFlags aspect, VkImageLayout from,
                       VkImageLayout to);

}  // namespace reprise

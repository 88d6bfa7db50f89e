// Images with seeded contents for every kind of descriptor that reads one.
#pragma once

#include "profiler/harness/made_up_values.h"
#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"

namespace reprise {

// Multisampled images have four samples (made_up_samples.h). Sampled images have mip levels that differ, so that a wrong derivative shows; storage images have one level, in GENERAL layout.
// Errors: harness.unsupported (kInput), device.*.
Result<Image> madeUpImage(const Context& context, Commands& commands, const Descriptor& descriptor, MadeUpValues& values);

// In which layout madeUpImage leaves an image.
VkImageLayout layoutOf(const Descriptor& descriptor);

}  // namespace reprise

// Formats and kinds of the package as Vulkan's, and what can be asked of a depth format.
#pragma once

#include <vulkan/vulkan_core.h>

#include "runtime/package/recipe.h"

namespace reprise {

VkFormat vulkanFormat(ResourceFormat format);
VkDescriptorType descriptorType(DescriptorKind kind);
bool hasStencil(VkFormat format);

}  // namespace reprise

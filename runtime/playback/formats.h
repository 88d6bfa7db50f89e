// Recipe formats as Vulkan's, and what can be asked of a depth format.
#pragma once

#include <vulkan/vulkan_core.h>

#include "runtime/package/recipe.h"

namespace reprise {

VkFormat vulkanFormat(ResourceFormat format);
bool hasStencil(VkFormat format);

}  // namespace reprise

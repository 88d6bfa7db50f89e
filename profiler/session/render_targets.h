// Images that a frame, or a pass before it, is rendered to.
#pragma once

#include <vector>

#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"

namespace reprise {

// Colour and depth targets of one frame, in attachment layouts.
struct RenderTargets {
  std::vector<Image> colors;
  Image depth;
  VkExtent2D extent = {};
};

struct TargetFormats {
  VkExtent2D extent = {};
  std::vector<VkFormat> colors;
  VkFormat depth = VK_FORMAT_D32_SFLOAT;
  bool sampled = false;  // shaders will read them
};

// In no layout yet. Errors: device.memory, device.call.
Result<RenderTargets> createRenderTargets(const DeviceView& device, const TargetFormats& formats);

// Depth, and stencil where the format has one.
VkImageAspectFlags depthAspect(VkFormat format);

// For targets that shaders sample between two renderings: into attachment layouts, what they held is lost; and back into
// SHADER_READ_ONLY_OPTIMAL, visible to all later shaders. The depth must have no stencil.
void beginWriting(const DeviceView& device, VkCommandBuffer commands, const RenderTargets& targets);
void endWriting(const DeviceView& device, VkCommandBuffer commands, const RenderTargets& targets);

}  // namespace reprise

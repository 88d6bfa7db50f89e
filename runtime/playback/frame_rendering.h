// Begins the rendering instances of a frame: attachments, load operations, viewport and scissor.
#pragma once

#include <cstdint>
#include <set>

#include "runtime/playback/history_images.h"
#include "runtime/playback/player.h"
#include "runtime/vulkan/device.h"

namespace reprise {

// What a rendering instance is made of, and what earlier ones of the frame have done to the application's targets.
struct RenderingParts {
  const FrameInputs* inputs = nullptr;
  ImagesByName* images = nullptr;
  std::uint64_t frame = 0;
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  bool marks_stencil = false;  // some pass of the recipe uses the stencil
  std::set<int> used_targets;  // application targets that hold content of this frame
  bool depth_used = false;
};

// Attachments by output location; an application target is cleared by the first rendering that uses it. The stencil is
// cleared where the depth is, and also where the application keeps its depth but the recipe marks.
void beginRendering(const DeviceView& device, VkCommandBuffer commands, const Pass& pass, RenderingParts& parts);

}  // namespace reprise

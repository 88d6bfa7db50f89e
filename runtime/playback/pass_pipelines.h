// One pipeline for each pass of a recipe, derived from the application's create-info.
#pragma once

#include <vector>

#include "runtime/playback/player.h"
#include "runtime/vulkan/device.h"
#include "runtime/vulkan/handle.h"

namespace reprise {

struct PassPipelines {
  std::vector<Handle<VkDescriptorSetLayout>> own_layouts;  // Reprise's set last, empty ones that fill gaps before it
  Handle<VkPipelineLayout> layout;
  std::vector<Handle<VkPipeline>> pipelines;               // by pass
};

// Errors: device.call and device.memory (kMachine).
Result<PassPipelines> createPipelines(const DeviceView& device, const Package& package, const Recipe& recipe,
                                      const ApplicationPipeline& application);

// Attachment formats of a pass, by output location; VK_FORMAT_UNDEFINED where nothing is attached.
std::vector<VkFormat> attachmentFormats(const Recipe& recipe, const Pass& pass, const ApplicationPipeline& application);

}  // namespace reprise

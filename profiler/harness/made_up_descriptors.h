// Everything that a shader's descriptors may refer to, made up and bound.
#pragma once

#include <deque>
#include <vector>

#include "profiler/harness/made_up_images.h"
#include "runtime/vulkan/buffer.h"

namespace reprise {

struct MadeUpDescriptors {
  std::vector<Handle<VkDescriptorSetLayout>> layouts;  // sets 0..; empty ones fill gaps
  Handle<VkDescriptorPool> pool;
  std::vector<VkDescriptorSet> sets;
  std::deque<Buffer> buffers;
  std::vector<Handle<VkBufferView>> views;
  std::deque<Image> images;
  std::vector<Handle<VkSampler>> samplers;
};

// `own`: the descriptor that the caller writes by itself, a uniform buffer of one dynamic offset. Errors: harness.unsupported
// (kInput), device.*.
Result<MadeUpDescriptors> makeUpDescriptors(const Context& context, Commands& commands, const ShaderInterface& interface,
                                            const Descriptor* own, MadeUpValues& values);

}  // namespace reprise

// Everything that a shader's descriptors may refer to, made up and bound.
#pragma once

#include <deque>
#include <vector>

#include "profiler/harness/integer_inputs.h"
#include "profiler/harness/made_up_images.h"
#include "runtime/vulkan/buffer.h"

namespace reprise {

// A uniform block whose contents change from frame to frame.
struct MovingBlock {
  std::vector<BlockMember> members;
  std::vector<std::byte> bytes;  // at frame 0
  std::size_t buffer = 0;
};

struct MadeUpDescriptors {
  std::vector<Handle<VkDescriptorSetLayout>> layouts;  // sets 0..; empty ones fill gaps
  Handle<VkDescriptorPool> pool;
  std::vector<VkDescriptorSet> sets;
  std::deque<Buffer> buffers;
  std::vector<MovingBlock> moving;
  std::vector<Handle<VkBufferView>> views;
  std::deque<Image> images;
  std::vector<Handle<VkSampler>> samplers;
};

// Integers that `given` names are as it says. `own`: the descriptor that the caller writes by itself, a uniform buffer of one dynamic offset. Errors: harness.unsupported
// (kInput), device.*.
Result<MadeUpDescriptors> makeUpDescriptors(const Context& context, Commands& commands, const ShaderInterface& interface,
                                            const Descriptor* own, const IntegerAssignment& given, MadeUpValues& values);

// Writes what the uniform blocks hold at a frame. No draw that reads them may be in flight.
void moveBlocks(MadeUpDescriptors& descriptors, int frame);

}  // namespace reprise

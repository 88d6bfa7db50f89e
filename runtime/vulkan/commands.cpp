#include "runtime/vulkan/commands.h"

namespace reprise {

Result<Commands> Commands::create(const Context& context) { return create(context.view(), context.queue(), context.queue_family()); }

Result<Commands> Commands::create(const DeviceView& device, VkQueue queue, std::uint32_t queue_family) {
  Commands commands;
  commands.device_ = device;
  commands.queue_ = queue;
  VkCommandPoolCreateInfo pool_create{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool_create.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool_create.queueFamilyIndex = queue_family;
  VkCommandPool pool = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateCommandPool(device.device, &pool_create, nullptr, &pool));
  commands.pool_ = {device.device, pool, device.fn.vkDestroyCommandPool};
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool;
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  REPRISE_VK(device.fn.vkAllocateCommandBuffers(device.device, &allocate, &commands.buffer_));
  const VkFenceCreateInfo fence_create{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateFence(device.device, &fence_create, nullptr, &fence));
  commands.fence_ = {device.device, fence, device.fn.vkDestroyFence};
  return commands;
}

Result<void> Commands::run(const std::function<Result<void>(VkCommandBuffer)>& record_commands, double timeout_s) {
  REPRISE_TRY(record(record_commands));
  return submitAndWait(timeout_s);
}

Result<void> Commands::record(const std::function<Result<void>(VkCommandBuffer)>& record_commands) {
  REPRISE_VK(device_.fn.vkResetCommandBuffer(buffer_, 0));
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  REPRISE_VK(device_.fn.vkBeginCommandBuffer(buffer_, &begin));
  const Result<void> recorded = record_commands(buffer_);
  REPRISE_VK(device_.fn.vkEndCommandBuffer(buffer_));
  return recorded;
}

Result<void> Commands::submitAndWait(double timeout_s) {
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &buffer_;
  const VkFence fence = fence_.get();
  REPRISE_VK(device_.fn.vkResetFences(device_.device, 1, &fence));
  REPRISE_VK(device_.fn.vkQueueSubmit(queue_, 1, &submit, fence));
  REPRISE_VK(device_.fn.vkWaitForFences(device_.device, 1, &fence, VK_TRUE, static_cast<std::uint64_t>(timeout_s * 1e9)));
  return {};
}

void changeLayout(const DeviceView& device, VkCommandBuffer commands, const LayoutChange& change) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT | VK_ACCESS_MEMORY_READ_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_WRITE_BIT | VK_ACCESS_MEMORY_READ_BIT;
  barrier.oldLayout = change.from;
  barrier.newLayout = change.to;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = change.image;
  barrier.subresourceRange = {change.aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  device.fn.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                                 nullptr, 0, nullptr, 1, &barrier);
}

}  // namespace reprise

#include "targets.h"

namespace embed {

namespace {

struct Transition {
  VkImage image = VK_NULL_HANDLE;
  VkImageAspectFlags aspect = 0;
  VkImageLayout from = VK_IMAGE_LAYOUT_UNDEFINED, to = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 from_stage = 0, to_stage = 0;
  VkAccessFlags2 from_access = 0, to_access = 0;
};

void recordTransition(VkCommandBuffer commands, const Transition& transition) {
  VkImageMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = transition.from_stage;
  barrier.srcAccessMask = transition.from_access;
  barrier.dstStageMask = transition.to_stage;
  barrier.dstAccessMask = transition.to_access;
  barrier.oldLayout = transition.from;
  barrier.newLayout = transition.to;
  barrier.image = transition.image;
  barrier.subresourceRange = {transition.aspect, 0, 1, 0, 1};
  VkDependencyInfo dependency{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

Targets::Targets(VulkanApp& app, VkExtent2D extent) : extent_(extent) {
  color_ = app.createImage({.format = kColorFormat,
                            .extent = extent,
                            .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                            .aspect = VK_IMAGE_ASPECT_COLOR_BIT});
  depth_ = app.createImage({.format = kDepthFormat,
                            .extent = extent,
                            .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                            .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
  pixels_ =
      app.createBuffer(VkDeviceSize{extent.width} * extent.height * 4, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
}

void Targets::recordBegin(VkCommandBuffer commands) const {
  recordTransition(commands, {.image = color_.handle,
                              .aspect = VK_IMAGE_ASPECT_COLOR_BIT,
                              .to = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                              .from_stage = VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                              .to_stage = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              .to_access = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                                           VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT});
  constexpr VkPipelineStageFlags2 kDepthStages =
      VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
  recordTransition(commands, {.image = depth_.handle,
                              .aspect = VK_IMAGE_ASPECT_DEPTH_BIT,
                              .to = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                              .from_stage = kDepthStages,
                              .to_stage = kDepthStages,
                              .from_access = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                              .to_access = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                           VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT});
}

void Targets::recordReadBack(VkCommandBuffer commands) const {
  recordTransition(commands, {.image = color_.handle,
                              .aspect = VK_IMAGE_ASPECT_COLOR_BIT,
                              .from = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                              .to = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                              .from_stage = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                              .to_stage = VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                              .from_access = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                              .to_access = VK_ACCESS_2_TRANSFER_READ_BIT});
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  copy.imageExtent = {extent_.width, extent_.height, 1};
  vkCmdCopyImageToBuffer(commands, color_.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels_.handle, 1,
                         &copy);

  VkMemoryBarrier2 to_host{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  to_host.srcStageMask = VK_PIPELINE_STAGE_2_TRANSFER_BIT;
  to_host.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  to_host.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  to_host.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  VkDependencyInfo dependency{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &to_host;
  vkCmdPipelineBarrier2(commands, &dependency);
}

std::vector<std::uint8_t> Targets::pixels() const {
  const auto* bytes = static_cast<const std::uint8_t*>(pixels_.mapped);
  return {bytes, bytes + std::size_t{extent_.width} * extent_.height * 4};
}

}  // namespace embed

#include "profiler/session/render_targets.h"

#include "runtime/playback/formats.h"

namespace reprise {
namespace {

constexpr VkPipelineStageFlags kAttachmentStages =
    VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags kShaderStages = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;

struct Change {
  VkImageLayout from, to;
  VkAccessFlags source, destination;
};

VkImageMemoryBarrier barrierOf(const Image& image, VkImageAspectFlags aspect, const Change& change) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = change.source;
  barrier.dstAccessMask = change.destination;
  barrier.oldLayout = change.from;
  barrier.newLayout = change.to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.image.get();
  barrier.subresourceRange = {aspect, 0, 1, 0, 1};
  return barrier;
}

}  // namespace

VkImageAspectFlags depthAspect(VkFormat format) {
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_DEPTH_BIT;
  if (hasStencil(format)) aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
  return aspect;
}

Result<RenderTargets> createRenderTargets(const DeviceView& device, const TargetFormats& formats) {
  RenderTargets targets;
  targets.extent = formats.extent;
  VkImageUsageFlags sampled = 0;
  if (formats.sampled) sampled = VK_IMAGE_USAGE_SAMPLED_BIT;
  ImageDescription description;
  description.extent = {targets.extent.width, targets.extent.height, 1};
  description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | sampled;
  for (const VkFormat format : formats.colors) {
    description.format = format;
    REPRISE_ASSIGN(Image image, createImage(device, description));
    targets.colors.push_back(std::move(image));
  }
  description.format = formats.depth;
  description.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | sampled;
  description.aspect = depthAspect(formats.depth);
  REPRISE_ASSIGN(targets.depth, createImage(device, description));
  return targets;
}

void beginWriting(const DeviceView& device, VkCommandBuffer commands, const RenderTargets& targets) {
  std::vector<VkImageMemoryBarrier> barriers;
  for (const Image& color : targets.colors)
    barriers.push_back(barrierOf(color, VK_IMAGE_ASPECT_COLOR_BIT, {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, 0,
                                                                    VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT}));
  barriers.push_back(barrierOf(targets.depth, VK_IMAGE_ASPECT_DEPTH_BIT,
                               {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, 0,
                                VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT}));
  // After the shaders of the last frame have read it.
  device.fn.vkCmdPipelineBarrier(commands, kShaderStages, kAttachmentStages, 0, 0, nullptr, 0, nullptr, static_cast<std::uint32_t>(barriers.size()),
                                 barriers.data());
}

void endWriting(const DeviceView& device, VkCommandBuffer commands, const RenderTargets& targets) {
  std::vector<VkImageMemoryBarrier> barriers;
  for (const Image& color : targets.colors)
    barriers.push_back(barrierOf(color, VK_IMAGE_ASPECT_COLOR_BIT, {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                                                    VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT, VK_ACCESS_SHADER_READ_BIT}));
  barriers.push_back(barrierOf(targets.depth, VK_IMAGE_ASPECT_DEPTH_BIT, {VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                                                          VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_ACCESS_SHADER_READ_BIT}));
  device.fn.vkCmdPipelineBarrier(commands, kAttachmentStages, kShaderStages, 0, 0, nullptr, 0, nullptr, static_cast<std::uint32_t>(barriers.size()),
                                 barriers.data());
}

}  // namespace reprise

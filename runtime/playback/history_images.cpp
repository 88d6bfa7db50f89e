#include "runtime/playback/history_images.h"

#include <algorithm>
#include <cmath>

#include "runtime/playback/formats.h"

namespace reprise {
namespace {

struct Usage {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

Usage usageOf(VkImageLayout layout) {
  if (layout == VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL)
    return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
            VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT};
  // Sampled by frames, copied by tools.
  return {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_SHADER_READ_BIT};
}

}  // namespace

Result<ImagesByName> createResourceImages(const DeviceView& device, const Recipe& recipe, VkExtent2D extent) {
  ImagesByName images;
  for (const Resource& resource : recipe.resources) {
    ImageDescription description;
    description.format = vulkanFormat(resource.format);
    const auto scaled = [&](std::uint32_t size) {
      return std::max(1u, static_cast<std::uint32_t>(std::lround(static_cast<float>(size) * resource.scale)));
    };
    description.extent = {scaled(extent.width), scaled(extent.height), 1};
    description.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    ResourceImages entry{resource, {}};
    for (int i = 0; i < (resource.lifetime == Lifetime::kHistory ? 2 : 1); ++i) {
      REPRISE_ASSIGN(Image image, createImage(device, description));
      entry.images.push_back({std::move(image), VK_IMAGE_LAYOUT_UNDEFINED});
    }
    images.emplace(resource.name, std::move(entry));
  }
  return images;
}

void transition(const DeviceView& device, VkCommandBuffer commands, TrackedImage& image, const ImageChange& change) {
  if (image.layout == change.layout && !change.discard) return;
  Usage before = usageOf(image.layout), after = usageOf(change.layout);
  if (image.layout == VK_IMAGE_LAYOUT_UNDEFINED) before.access = 0;
  if (change.without_dependency) {
    before = {VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, 0};
    after = {VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0};
  }
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = before.access;
  barrier.dstAccessMask = after.access;
  barrier.oldLayout = change.discard ? VK_IMAGE_LAYOUT_UNDEFINED : image.layout;
  barrier.newLayout = change.layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.image.image.get();
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  device.fn.vkCmdPipelineBarrier(commands, before.stages, after.stages, 0, 0, nullptr, 0, nullptr, 1, &barrier);
  image.layout = change.layout;
}

}  // namespace reprise

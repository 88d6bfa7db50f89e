#include "runtime/vulkan/upload.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "runtime/vulkan/buffer.h"

namespace reprise {
namespace {

void levelBarrier(const DeviceView& device, VkCommandBuffer commands, VkImage image, std::uint32_t level) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, level, 1, 0, 1};
  device.fn.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0,
                                 nullptr, 1, &barrier);
}

// Each level is a filtered blit of the one above; leaves all levels in TRANSFER_SRC_OPTIMAL.
void makeLevels(const DeviceView& device, VkCommandBuffer commands, const Image& image) {
  auto width = static_cast<std::int32_t>(image.extent.width), height = static_cast<std::int32_t>(image.extent.height);
  for (std::uint32_t level = 0; level < image.mip_levels; ++level) {
    levelBarrier(device, commands, image.image.get(), level);
    if (level + 1 == image.mip_levels) break;
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
    blit.srcOffsets[1] = {width, height, 1};
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level + 1, 0, 1};
    blit.dstOffsets[1] = {width, height, 1};
    device.fn.vkCmdBlitImage(commands, image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.image.get(),
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
  }
}

}  // namespace

Result<Image> uploadTexture(const Context& context, Commands& commands, const UploadDescription& description,
                            std::span<const std::byte> texels) {
  const DeviceView& device = context.view();
  ImageDescription create;
  create.format = description.format;
  create.extent = {description.extent.width, description.extent.height, 1};
  create.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (description.mipmaps)
    create.mip_levels = static_cast<std::uint32_t>(std::bit_width(std::max(description.extent.width, description.extent.height)));
  REPRISE_ASSIGN(Image image, createImage(device, create));
  REPRISE_ASSIGN(const Buffer staging, createBuffer(device, texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
  std::memcpy(staging.mapped.data(), texels.data(), texels.size());
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    changeLayout(device, buffer, {image.image.get(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL});
    VkBufferImageCopy copy{};
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = image.extent;
    device.fn.vkCmdCopyBufferToImage(buffer, staging.buffer.get(), image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    makeLevels(device, buffer, image);
    changeLayout(device, buffer, {image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    return {};
  }));
  return image;
}

}  // namespace reprise

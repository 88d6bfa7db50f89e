#include "profiler/harness/made_up_images.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/vulkan/buffer.h"

namespace reprise {
namespace {

struct Shape {
  VkExtent3D extent = {1, 1, 1};
  std::uint32_t layers = 1;
  VkImageViewType view = VK_IMAGE_VIEW_TYPE_2D;
};

Shape shapeOf(ImageDimension dimension) {
  switch (dimension) {
    case ImageDimension::k1D: return {{16, 1, 1}, 1, VK_IMAGE_VIEW_TYPE_1D};
    case ImageDimension::k1DArray: return {{16, 1, 1}, 4, VK_IMAGE_VIEW_TYPE_1D_ARRAY};
    case ImageDimension::k3D: return {{8, 8, 8}, 1, VK_IMAGE_VIEW_TYPE_3D};
    case ImageDimension::kCube: return {{16, 16, 1}, 6, VK_IMAGE_VIEW_TYPE_CUBE};
    case ImageDimension::k2DArray: return {{16, 16, 1}, 4, VK_IMAGE_VIEW_TYPE_2D_ARRAY};
    case ImageDimension::kCubeArray: return {{16, 16, 1}, 12, VK_IMAGE_VIEW_TYPE_CUBE_ARRAY};
    case ImageDimension::k2D:
    case ImageDimension::kNone: break;
  }
  return {{16, 16, 1}, 1, VK_IMAGE_VIEW_TYPE_2D};
}

struct Texels {
  VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
  std::size_t channels = 4;
};

Result<Texels> texelsOf(const Descriptor& descriptor) {
  if (descriptor.compares) return Texels{VK_FORMAT_D32_SFLOAT, 1};
  const std::string& format = descriptor.storage_format;
  if (format == "other" || format == "rgba16f" || format == "rgba8")
    return Error{ErrorKind::kInput, "harness.unsupported", "no contents are made up for the storage image '" + descriptor.name + "'", {}};
  if (format == "r32f") return Texels{VK_FORMAT_R32_SFLOAT, 1};
  if (format == "r32i") return Texels{VK_FORMAT_R32_SINT, 1};
  if (format == "r32ui") return Texels{VK_FORMAT_R32_UINT, 1};
  if (descriptor.texel == ScalarKind::kInt) return Texels{VK_FORMAT_R32G32B32A32_SINT, 4};
  if (descriptor.texel == ScalarKind::kUint) return Texels{VK_FORMAT_R32G32B32A32_UINT, 4};
  return Texels{};
}

VkExtent3D levelExtent(VkExtent3D extent, std::uint32_t level) {
  return {std::max(extent.width >> level, 1u), std::max(extent.height >> level, 1u), std::max(extent.depth >> level, 1u)};
}

// Smooth with noise on top, so that filtering and its coordinates both show.
void fillLevel(std::byte* to, VkExtent3D extent, const Descriptor& descriptor, const Texels& texels, MadeUpValues& values) {
  const float phase = 6.28f * values.fraction();
  for (std::uint32_t z = 0; z < extent.depth; ++z)
    for (std::uint32_t y = 0; y < extent.height; ++y)
      for (std::uint32_t x = 0; x < extent.width; ++x)
        for (std::size_t channel = 0; channel < texels.channels; ++channel, to += 4) {
          const std::uint32_t whole = values.below(4);
          const float wave = 0.5f + 0.35f * std::sin(phase + 0.7f * static_cast<float>(x) + 0.5f * static_cast<float>(y + z) +
                                                     static_cast<float>(channel)) + 0.15f * (values.fraction() - 0.5f);
          if (descriptor.texel == ScalarKind::kFloat) std::memcpy(to, &wave, 4);
          else std::memcpy(to, &whole, 4);
        }
}

VkImageMemoryBarrier barrier(const Image& image, VkImageAspectFlags aspect, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier change{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  change.srcAccessMask = change.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  change.oldLayout = from;
  change.newLayout = to;
  change.srcQueueFamilyIndex = change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.image = image.image.get();
  change.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  return change;
}

}  // namespace

VkImageLayout layoutOf(const Descriptor& descriptor) {
  return descriptor.kind == DescriptorKind::kStorageImage ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

Result<Image> madeUpImage(const Context& context, Commands& commands, const Descriptor& descriptor, MadeUpValues& values) {
  if (descriptor.multisampled)
    return Error{ErrorKind::kInput, "harness.unsupported", "no contents are made up for the multisampled image '" + descriptor.name + "'", {}};
  REPRISE_ASSIGN(const Texels texels, texelsOf(descriptor));
  const Shape shape = shapeOf(descriptor.dimension);
  const DeviceView& device = context.view();
  const bool stores = descriptor.kind == DescriptorKind::kStorageImage;
  const VkImageAspectFlags aspect = descriptor.compares ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  const VkImageUsageFlags usage =
      VK_IMAGE_USAGE_TRANSFER_DST_BIT | VkImageUsageFlags{stores ? VK_IMAGE_USAGE_STORAGE_BIT : VK_IMAGE_USAGE_SAMPLED_BIT};
  const std::uint32_t levels = stores ? 1 : 3;
  REPRISE_ASSIGN(Image image, createImage(device, {texels.format, shape.extent, shape.layers, levels, usage, aspect, shape.view}));
  std::vector<VkBufferImageCopy> copies;
  VkDeviceSize size = 0;
  for (std::uint32_t level = 0; level < levels; ++level) {
    const VkExtent3D extent = levelExtent(shape.extent, level);
    for (std::uint32_t layer = 0; layer < shape.layers; ++layer) {
      copies.push_back({size, 0, 0, {aspect, level, layer, 1}, {}, extent});
      size += VkDeviceSize{extent.width} * extent.height * extent.depth * texels.channels * 4;
    }
  }
  REPRISE_ASSIGN(const Buffer staging, createBuffer(device, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
  for (const VkBufferImageCopy& copy : copies) fillLevel(&staging.mapped[copy.bufferOffset], copy.imageExtent, descriptor, texels, values);
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    constexpr VkPipelineStageFlags kAll = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    const VkImageMemoryBarrier before = barrier(image, aspect, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    device.fn.vkCmdPipelineBarrier(buffer, kAll, kAll, 0, 0, nullptr, 0, nullptr, 1, &before);
    device.fn.vkCmdCopyBufferToImage(buffer, staging.buffer.get(), image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                     static_cast<std::uint32_t>(copies.size()), copies.data());
    const VkImageMemoryBarrier after = barrier(image, aspect, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, layoutOf(descriptor));
    device.fn.vkCmdPipelineBarrier(buffer, kAll, kAll, 0, 0, nullptr, 0, nullptr, 1, &after);
    return {};
  }));
  return image;
}

}  // namespace reprise

#include "profiler/harness/made_up_images.h"

#include <algorithm>
#include <span>

#include "profiler/harness/made_up_samples.h"
#include "profiler/harness/texel_formats.h"
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

Result<TexelFormat> formatOf(const Descriptor& descriptor) {
  if (descriptor.kind != DescriptorKind::kStorageImage || descriptor.storage_format.empty()) return sampledFormat(descriptor.texel, descriptor.compares);
  const std::optional<TexelFormat> format = texelFormatNamed(descriptor.storage_format);
  if (!format)
    return Error{ErrorKind::kInput, "harness.unsupported", "no contents are made up for the storage image '" + descriptor.name + "'", {}};
  return *format;
}

VkExtent3D levelExtent(VkExtent3D extent, std::uint32_t level) {
  return {std::max(extent.width >> level, 1u), std::max(extent.height >> level, 1u), std::max(extent.depth >> level, 1u)};
}

void fillLevel(std::span<std::byte> to, VkExtent3D extent, const TexelFormat& format, MadeUpValues& values) {
  const float phase = 6.28f * values.fraction();
  std::size_t at = 0;
  for (std::uint32_t z = 0; z < extent.depth; ++z)
    for (std::uint32_t y = 0; y < extent.height; ++y)
      for (std::uint32_t x = 0; x < extent.width; ++x, at += format.bytes)
        encodeTexel(format, madeUpTexel(x, y + z, phase, format.channels, values), to.subspan(at, format.bytes));
}

}  // namespace

VkImageLayout layoutOf(const Descriptor& descriptor) {
  return descriptor.kind == DescriptorKind::kStorageImage ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

Result<Image> madeUpImage(const Context& context, Commands& commands, const Descriptor& descriptor, MadeUpValues& values) {
  REPRISE_ASSIGN(const TexelFormat format, formatOf(descriptor));
  if (descriptor.multisampled) return madeUpSamples(context, commands, descriptor, format, values);
  const Shape shape = shapeOf(descriptor.dimension);
  const DeviceView& device = context.view();
  const bool stores = descriptor.kind == DescriptorKind::kStorageImage;
  const VkImageAspectFlags aspect = descriptor.compares ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  const VkImageUsageFlags usage =
      VK_IMAGE_USAGE_TRANSFER_DST_BIT | VkImageUsageFlags{stores ? VK_IMAGE_USAGE_STORAGE_BIT : VK_IMAGE_USAGE_SAMPLED_BIT};
  const std::uint32_t levels = stores ? 1 : 3;
  REPRISE_ASSIGN(Image image, createImage(device, {format.format, shape.extent, shape.layers, levels, usage, aspect, shape.view}));
  std::vector<VkBufferImageCopy> copies;
  VkDeviceSize size = 0;
  for (std::uint32_t level = 0; level < levels; ++level) {
    const VkExtent3D extent = levelExtent(shape.extent, level);
    for (std::uint32_t layer = 0; layer < shape.layers; ++layer) {
      copies.push_back({size, 0, 0, {aspect, level, layer, 1}, {}, extent});
      // Copies start at multiples of four bytes.
      size += (VkDeviceSize{extent.width} * extent.height * extent.depth * format.bytes + 15) / 16 * 16;
    }
  }
  REPRISE_ASSIGN(const Buffer staging, createBuffer(device, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
  for (const VkBufferImageCopy& copy : copies)
    fillLevel(std::span<std::byte>(staging.mapped).subspan(copy.bufferOffset), copy.imageExtent, format, values);
  REPRISE_TRY(commands.run([&](VkCommandBuffer buffer) -> Result<void> {
    changeWholeLayout(device, buffer, image, aspect, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    device.fn.vkCmdCopyBufferToImage(buffer, staging.buffer.get(), image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                     static_cast<std::uint32_t>(copies.size()), copies.data());
    changeWholeLayout(device, buffer, image, aspect, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, layoutOf(descriptor));
    return {};
  }));
  return image;
}

}  // namespace reprise

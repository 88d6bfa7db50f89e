#include "runtime/vulkan/image.h"

namespace reprise {
namespace {

VkImageType imageType(VkImageViewType view) {
  switch (view) {
    case VK_IMAGE_VIEW_TYPE_1D:
    case VK_IMAGE_VIEW_TYPE_1D_ARRAY: return VK_IMAGE_TYPE_1D;
    case VK_IMAGE_VIEW_TYPE_3D: return VK_IMAGE_TYPE_3D;
    default: return VK_IMAGE_TYPE_2D;
  }
}

Result<void> bindMemory(const DeviceView& device, Image& image) {
  VkMemoryRequirements needs;
  device.fn.vkGetImageMemoryRequirements(device.device, image.image.get(), &needs);
  VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = memoryTypeIndex(device, needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkAllocateMemory(device.device, &allocate, nullptr, &memory));
  image.memory = {device.device, memory, device.fn.vkFreeMemory};
  REPRISE_VK(device.fn.vkBindImageMemory(device.device, image.image.get(), memory, 0));
  return {};
}

}  // namespace

Result<Image> createImage(const DeviceView& device, const ImageDescription& description) {
  Image result;
  result.format = description.format;
  result.extent = description.extent;
  result.layers = description.layers;
  result.mip_levels = description.mip_levels;
  VkImageCreateInfo create{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  const bool cube = description.view_type == VK_IMAGE_VIEW_TYPE_CUBE || description.view_type == VK_IMAGE_VIEW_TYPE_CUBE_ARRAY;
  create.flags = cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
  create.imageType = imageType(description.view_type);
  create.format = description.format;
  create.extent = description.extent;
  create.mipLevels = description.mip_levels;
  create.arrayLayers = description.layers;
  create.samples = description.samples;
  create.tiling = VK_IMAGE_TILING_OPTIMAL;
  create.usage = description.usage;
  VkImage image = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateImage(device.device, &create, nullptr, &image));
  result.image = {device.device, image, device.fn.vkDestroyImage};
  REPRISE_TRY(bindMemory(device, result));
  VkImageViewCreateInfo view_create{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view_create.image = image;
  view_create.viewType = description.view_type;
  view_create.format = description.format;
  view_create.subresourceRange = {description.aspect, 0, description.mip_levels, 0, description.layers};
  VkImageView view = VK_NULL_HANDLE;
  REPRISE_VK(device.fn.vkCreateImageView(device.device, &view_create, nullptr, &view));
  result.view = {device.device, view, device.fn.vkDestroyImageView};
  return result;
}

}  // namespace reprise

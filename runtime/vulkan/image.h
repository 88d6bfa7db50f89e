// An image with its own memory and a view of all of it.
#pragma once

#include "runtime/vulkan/device.h"
#include "runtime/vulkan/handle.h"

namespace reprise {

struct ImageDescription {
  VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
  VkExtent3D extent = {1, 1, 1};
  std::uint32_t layers = 1;
  std::uint32_t mip_levels = 1;
  VkImageUsageFlags usage = 0;
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;  // of the view
  VkImageViewType view_type = VK_IMAGE_VIEW_TYPE_2D;
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

struct Image {
  Handle<VkDeviceMemory> memory;  // before the image, so that it is freed after it
  Handle<VkImage> image;
  Handle<VkImageView> view;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent3D extent = {};
  std::uint32_t layers = 1, mip_levels = 1;
};

// Errors: device.memory, device.call.
Result<Image> createImage(const DeviceView& device, const ImageDescription& description);

}  // namespace reprise

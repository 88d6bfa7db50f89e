// The application's colour and depth images, and the way of the pixels back to the host.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

#include "vulkan_app.h"

namespace embed {

class Targets {
 public:
  static constexpr VkFormat kColorFormat = VK_FORMAT_R8G8B8A8_UNORM;
  static constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

  Targets(VulkanApp& app, VkExtent2D extent);

  VkExtent2D extent() const { return extent_; }
  VkImageView colorView() const { return color_.view; }
  VkImageView depthView() const { return depth_.view; }

  // Brings both images into the layouts that the player expects (those of ColorTarget and DepthTarget).
  void recordBegin(VkCommandBuffer commands) const;
  // Copies the colour image to the host; pixels() has it when the commands are done.
  void recordReadBack(VkCommandBuffer commands) const;
  std::vector<std::uint8_t> pixels() const;  // rows from the top, RGBA

 private:
  VkExtent2D extent_ = {};
  Image color_, depth_;
  Buffer pixels_;
};

}  // namespace embed

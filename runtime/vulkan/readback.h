// Images back to the host, for tools and tests.
#pragma once

#include <vector>

#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/commands.h"

namespace reprise {

struct ReadbackSource {
  VkImage image = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;  // colour formats of recipe.h and rgba8/16f/32f; D32_SFLOAT
  VkExtent2D extent = {};
  VkImageLayout layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;  // before and after
};

// Bytes per pixel of a format that can be read back; 0 for others.
std::uint32_t formatBytes(VkFormat format);

// A staging buffer that is kept from read to read.
class Readback {
 public:
  explicit Readback(const Context& context) : context_(&context) {}

  // Copies the first layer's first level; the returned bytes, rows from the top without padding, are valid until the next
  // call. Errors: readback.format (kMachine), device.*.
  Result<std::span<const std::byte>> read(Commands& commands, const ReadbackSource& source);

 private:
  const Context* context_;
  Buffer staging_;
};

// Texels as RGBA floats, integers by value; formats with fewer channels give 0 for green and blue, 1 for alpha.
std::vector<float> toFloats(std::span<const std::byte> bytes, VkFormat format);

}  // namespace reprise

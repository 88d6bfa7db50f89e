// Textures onto the device, with a full mip chain where asked for.
#pragma once

#include <span>

#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/image.h"

namespace reprise {

struct UploadDescription {
  VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;  // linearly filterable where mipmaps are wanted
  VkExtent2D extent = {};
  bool mipmaps = false;
};

// texels: rows from the top, tightly packed, of `format`. The image ends in SHADER_READ_ONLY_OPTIMAL.
Result<Image> uploadTexture(const Context& context, Commands& commands, const UploadDescription& description,
                            std::span<const std::byte> texels);

}  // namespace reprise

// The images of a recipe's resources, their roles from frame to frame, and their layouts.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "runtime/package/recipe.h"
#include "runtime/vulkan/image.h"

namespace reprise {

struct TrackedImage {
  Image image;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

struct ResourceImages {
  Resource resource;
  std::vector<TrackedImage> images;  // two for histories, else one

  TrackedImage& written(std::uint64_t frame) { return images[frame % images.size()]; }
  // Last frame's image of a history; the image itself where there is only one.
  TrackedImage& last(std::uint64_t frame) { return images[(frame + 1) % images.size()]; }
};

using ImagesByName = std::map<std::string, ResourceImages>;

// Errors: device.memory, device.call.
Result<ImagesByName> createResourceImages(const DeviceView& device, const Recipe& recipe, VkExtent2D extent);

struct ImageChange {
  VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  bool discard = false;            // drops the content
  bool without_dependency = false; // for the test that shows that validation notices
};

// Brings an image into a layout with the dependencies that frames need: fragment reads and transfers before, or colour writes
// before. No barrier where nothing changes.
void transition(const DeviceView& device, VkCommandBuffer commands, TrackedImage& image, const ImageChange& change);

}  // namespace reprise

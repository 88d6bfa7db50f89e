// The flags of a target's tiles: fragments that leave something to finish set theirs, and the draw of tiles skips the others.
#pragma once

#include <cstdint>

#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/device.h"

namespace reprise {

class TileFlags {
 public:
  // For targets of this size. The device has finished with the old ones. Errors: device.memory, device.call.
  Result<void> resize(const DeviceView& device, VkExtent2D extent);

  // Records that all flags become 0, after what an earlier frame does with them.
  void clear(const DeviceView& device, VkCommandBuffer commands) const;
  // Records the dependency of a draw of tiles on the fragments before it. Not inside a rendering.
  void makeVisible(const DeviceView& device, VkCommandBuffer commands) const;
  // Records the draw of all tiles, with a viewport of whole tiles, which may reach beyond the target.
  void drawTiles(const DeviceView& device, VkCommandBuffer commands) const;

  VkBuffer buffer() const { return flags_.buffer.get(); }
  std::uint32_t across() const;
  std::uint32_t down() const;
  std::uint32_t count() const;

 private:
  Buffer flags_;
  VkExtent2D extent_ = {};
};

}  // namespace reprise

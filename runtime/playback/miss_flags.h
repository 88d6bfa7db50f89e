// Flags that fragments set for what they leave to a later pass: a uint each, of the target's tiles (tile_flags.h) or of the frame's draws.
#pragma once

#include <cstdint>

#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/device.h"

namespace reprise {

// What looks at the flags once they are set. kConditions: conditional rendering, by which a draw is left out where its flag is 0.
enum class FlagReader { kVertexShaders, kConditions };

class MissFlags {
 public:
  // Room for `count` flags; grows, never shrinks. The device has finished with the old ones. kConditions needs
  // VK_EXT_conditional_rendering, enabled. Errors: device.memory, device.call.
  Result<void> reserve(const DeviceView& device, std::uint32_t count, FlagReader reader);

  // Records that all flags become 0, after what an earlier frame does with them.
  void clear(const DeviceView& device, VkCommandBuffer commands) const;
  // Records the dependency of the reader, and of countSet, on the fragments before it. Not inside a rendering.
  void makeVisible(const DeviceView& device, VkCommandBuffer commands) const;

  // How many of the first `count` flags are set; the device has finished with them.
  std::uint32_t countSet(std::uint32_t count) const;

  VkBuffer buffer() const { return flags_.buffer.get(); }

 private:
  Buffer flags_;
  std::uint32_t capacity_ = 0;
  FlagReader reader_ = FlagReader::kVertexShaders;
};

}  // namespace reprise

// The flags of a target's tiles: fragments that leave something to finish set theirs, and the draw of tiles skips the others.
#pragma once

#include <cstdint>

#include "runtime/playback/miss_flags.h"

namespace reprise {

class TileFlags {
 public:
  // For targets of this size. The device has finished with the old ones. Errors: device.memory, device.call.
  Result<void> resize(const DeviceView& device, VkExtent2D extent);

  // Records the draw of all tiles, with a viewport of whole tiles, which may reach beyond the target.
  void drawTiles(const DeviceView& device, VkCommandBuffer commands) const;

  const MissFlags& flags() const { return flags_; }
  std::uint32_t across() const;
  std::uint32_t down() const;
  std::uint32_t count() const;

 private:
  MissFlags flags_;
  VkExtent2D extent_ = {};
};

}  // namespace reprise

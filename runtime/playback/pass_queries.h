// The application's queries around the passes of a frame, where it gave any: a time stamp before the first pass and after each, and an
// occlusion query in each.
#pragma once

#include <cstdint>

#include "runtime/playback/player.h"
#include "runtime/vulkan/device.h"

namespace reprise {

class PassQueries {
 public:
  // Records the reset of the queries and the first time stamp. `device` and `inputs` outlive the object.
  PassQueries(const DeviceView& device, VkCommandBuffer commands, const FrameInputs& inputs, std::uint32_t passes);

  void beginCounting(std::uint32_t pass) const;  // before its draws
  void endCounting(std::uint32_t pass) const;    // after them, inside the same rendering or outside of all
  void stampEnd(std::uint32_t pass) const;       // outside of renderings where the pass ends one

 private:
  const DeviceView& device_;
  VkCommandBuffer commands_;
  const FrameInputs& inputs_;
};

}  // namespace reprise

// A pass as the application sees it while it draws: binds the player's set for each object, and opens the object's condition where the pass
// draws flagged objects alone.
#pragma once

#include <cstdint>
#include <map>

#include "runtime/playback/draw_uniforms.h"
#include "runtime/playback/player.h"
#include "runtime/vulkan/device.h"

namespace reprise {

// Where a draw of the frame has its numbers.
struct DrawPlace {
  std::uint32_t index = 0;  // among the frame's draws
  DrawOffsets offsets;
};

class RecordingPass final : public PassContext {
 public:
  struct Parts {
    const DeviceView* device;
    VkCommandBuffer commands;
    VkPipelineLayout layout;
    int pass;
    bool binds;  // the player's set
    std::uint32_t set_index;
    VkDescriptorSet set;
    const std::map<std::uint64_t, DrawPlace>* places;  // by draw id
    VkBuffer conditions;  // a flag for each draw, without which it is left out; null: all are drawn
    bool* drawn;          // becomes true with the first draw
  };
  explicit RecordingPass(const Parts& parts) : parts_(parts) {}

  VkCommandBuffer commands() const override { return parts_.commands; }
  VkPipelineLayout layout() const override { return parts_.layout; }
  int pass() const override { return parts_.pass; }
  void bindDraw(std::uint64_t id) override;
  // After the last draw of an object, or of the pass.
  void endObject();

 private:
  Parts parts_;
  bool conditional_ = false;  // rendering, since the last bindDraw
};

}  // namespace reprise

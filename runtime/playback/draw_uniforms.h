// What the vertex side needs of the last frame: the content of uniform blocks and push constants, by draw id.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "runtime/playback/player.h"
#include "runtime/vulkan/buffer.h"

namespace reprise {

// Bytes of one draw's inputs, in the order of Recipe::previous_inputs.
using DrawBytes = std::vector<std::vector<std::byte>>;

// This frame's bytes of every draw. Error (kInput): player.input_missing, naming the block and the draw.
Result<std::map<std::uint64_t, DrawBytes>> collectDrawBytes(const Recipe& recipe, const FrameInputs& frame);

// Dynamic offsets of one draw, in binding order: binding 1, then the previous blocks.
using DrawOffsets = std::vector<std::uint32_t>;

// One frame's uniform memory: FrameUniforms at 0, then for each draw its block of binding 1 and its previous blocks.
class UniformRegion {
 public:
  // Makes room for `draws` draws; grows, never shrinks.
  Result<void> reserve(const DeviceView& device, const Recipe& recipe, std::size_t draws, VkDeviceSize alignment);

  void writeFrame(const FrameUniforms& uniforms);
  // `index`: of the draw among the frame's. `last` null: it was absent last frame; `current` stands in so that nothing undefined is read.
  DrawOffsets writeDraw(const Recipe& recipe, std::size_t index, const DrawBytes* last, const DrawBytes& current);

  VkBuffer buffer() const { return memory_.buffer.get(); }
  // Byte size of the binding-1 block, and of one previous input.
  static std::uint32_t drawBlockBytes(const Recipe& recipe);

 private:
  Buffer memory_;
  std::size_t capacity_ = 0;
  VkDeviceSize alignment_ = 256;
  VkDeviceSize stride_ = 0;
  VkDeviceSize first_ = 0;
};

}  // namespace reprise

#include "runtime/playback/draw_uniforms.h"

#include <algorithm>
#include <cstring>

namespace reprise {
namespace {

constexpr std::uint32_t kPushConstantOffset = 16;

VkDeviceSize aligned(VkDeviceSize size, VkDeviceSize alignment) { return (size + alignment - 1) / alignment * alignment; }

Result<std::vector<std::byte>> bytesFor(const PreviousInput& input, const DrawInputs& draw) {
  std::span<const std::byte> found;
  if (input.source == PreviousSource::kPushConstants) {
    found = draw.push_constants;
  } else {
    for (const BlockBytes& block : draw.blocks)
      if (block.set == input.set && block.binding == input.binding) found = block.bytes;
  }
  // Blocks are padded to 16 bytes in the recipe; push constants need not be given with the padding.
  const bool enough = !found.empty() && aligned(found.size(), 16) >= input.size_bytes;
  if (!enough)
    return Error{ErrorKind::kInput, "player.input_missing",
                 "draw " + std::to_string(draw.id) + " needs the " + std::to_string(input.size_bytes) + " bytes of '" + input.name +
                     "' (the vertex position depends on it), but " + std::to_string(found.size()) + " were given", {}};
  std::vector<std::byte> bytes(input.size_bytes);
  std::memcpy(bytes.data(), found.data(), std::min<std::size_t>(found.size(), bytes.size()));
  return bytes;
}

}  // namespace

Result<std::map<std::uint64_t, DrawBytes>> collectDrawBytes(const Recipe& recipe, const FrameInputs& frame) {
  std::map<std::uint64_t, DrawBytes> draws;
  for (const DrawInputs& draw : frame.draws) {
    DrawBytes bytes;
    for (const PreviousInput& input : recipe.previous_inputs) {
      REPRISE_ASSIGN(std::vector<std::byte> content, bytesFor(input, draw));
      bytes.push_back(std::move(content));
    }
    if (!draws.emplace(draw.id, std::move(bytes)).second)
      return Error{ErrorKind::kInput, "player.draw_id", "draw id " + std::to_string(draw.id) + " stands for two draws of one frame", {}};
  }
  return draws;
}

std::uint32_t UniformRegion::drawBlockBytes(const Recipe& recipe) {
  std::uint32_t bytes = kPushConstantOffset;
  for (const PreviousInput& input : recipe.previous_inputs)
    if (input.source == PreviousSource::kPushConstants) bytes += input.size_bytes;
  return static_cast<std::uint32_t>(aligned(bytes, 16));
}

Result<void> UniformRegion::reserve(const DeviceView& device, const Recipe& recipe, std::size_t draws, VkDeviceSize alignment) {
  if (draws <= capacity_ && memory_.buffer) return {};
  alignment_ = alignment;
  first_ = aligned(sizeof(FrameUniforms), alignment);
  stride_ = aligned(drawBlockBytes(recipe), alignment);
  for (const PreviousInput& input : recipe.previous_inputs)
    if (input.source == PreviousSource::kUniformBlock) stride_ += aligned(input.size_bytes, alignment);
  capacity_ = std::max<std::size_t>(draws, 16);
  REPRISE_ASSIGN(memory_, createBuffer(device, first_ + stride_ * capacity_, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
  return {};
}

void UniformRegion::writeFrame(const FrameUniforms& uniforms) { std::memcpy(memory_.mapped.data(), &uniforms, sizeof uniforms); }

DrawOffsets UniformRegion::writeDraw(const Recipe& recipe, std::size_t index, const DrawBytes* last, const DrawBytes& current) {
  REPRISE_CHECK(index < capacity_, index, capacity_);
  VkDeviceSize offset = first_ + stride_ * index;
  DrawOffsets offsets{static_cast<std::uint32_t>(offset)};
  const DrawBytes& bytes = last != nullptr ? *last : current;
  const std::uint32_t head[] = {last != nullptr ? 1u : 0u, static_cast<std::uint32_t>(index)};
  std::memcpy(&memory_.mapped[offset], head, sizeof head);
  VkDeviceSize block = offset + aligned(drawBlockBytes(recipe), alignment_);
  for (std::size_t i = 0; i < recipe.previous_inputs.size(); ++i) {
    if (recipe.previous_inputs[i].source == PreviousSource::kPushConstants) {
      std::memcpy(&memory_.mapped[offset + kPushConstantOffset], bytes[i].data(), bytes[i].size());
      continue;
    }
    std::memcpy(&memory_.mapped[block], bytes[i].data(), bytes[i].size());
    offsets.push_back(static_cast<std::uint32_t>(block));
    block += aligned(bytes[i].size(), alignment_);
  }
  return offsets;
}

}  // namespace reprise

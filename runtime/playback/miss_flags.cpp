#include "runtime/playback/miss_flags.h"

#include <cstring>

namespace reprise {
namespace {

struct Side {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

constexpr Side kFlagged = {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT};
constexpr Side kCleared = {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT};

Side sideOf(FlagReader reader) {
  if (reader == FlagReader::kConditions) return {VK_PIPELINE_STAGE_CONDITIONAL_RENDERING_BIT_EXT, VK_ACCESS_CONDITIONAL_RENDERING_READ_BIT_EXT};
  return {VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT};
}

VkBufferUsageFlags usageFor(FlagReader reader) {
  const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  return reader == FlagReader::kConditions ? usage | VK_BUFFER_USAGE_CONDITIONAL_RENDERING_BIT_EXT : usage;
}

void depend(const DeviceView& device, VkCommandBuffer commands, const Side& before, const Side& after) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = before.access;
  barrier.dstAccessMask = after.access;
  device.fn.vkCmdPipelineBarrier(commands, before.stages, after.stages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

Result<void> MissFlags::reserve(const DeviceView& device, std::uint32_t count, FlagReader reader) {
  if (count <= capacity_) return {};
  REPRISE_ASSIGN(flags_, createBuffer(device, count * sizeof(std::uint32_t), usageFor(reader)));
  capacity_ = count;
  reader_ = reader;
  return {};
}

void MissFlags::clear(const DeviceView& device, VkCommandBuffer commands) const {
  depend(device, commands, {kFlagged.stages | sideOf(reader_).stages, kFlagged.access}, kCleared);
  device.fn.vkCmdFillBuffer(commands, buffer(), 0, VK_WHOLE_SIZE, 0);
  depend(device, commands, kCleared, kFlagged);
}

std::uint32_t MissFlags::countSet(std::uint32_t count) const {
  REPRISE_CHECK(count <= capacity_, count, capacity_);
  std::uint32_t set = 0;
  for (std::uint32_t index = 0; index < count; ++index) {
    std::uint32_t flag = 0;
    std::memcpy(&flag, &flags_.mapped[index * sizeof flag], sizeof flag);
    set += flag != 0 ? 1 : 0;
  }
  return set;
}

void MissFlags::makeVisible(const DeviceView& device, VkCommandBuffer commands) const {
  const auto [stages, access] = sideOf(reader_);
  depend(device, commands, kFlagged, {stages | VK_PIPELINE_STAGE_HOST_BIT, access | VK_ACCESS_HOST_READ_BIT});
}

}  // namespace reprise

#include "runtime/playback/tile_flags.h"

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

constexpr std::uint32_t kVerticesOfATile = 4;

std::uint32_t tilesIn(std::uint32_t pixels) { return (pixels + kTilePixels - 1) / kTilePixels; }

struct Side {
  VkPipelineStageFlags stages;
  VkAccessFlags access;
};

constexpr Side kFlagged = {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT};
constexpr Side kDrawn = {VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT};
constexpr Side kCleared = {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT};

void depend(const DeviceView& device, VkCommandBuffer commands, const Side& before, const Side& after) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = before.access;
  barrier.dstAccessMask = after.access;
  device.fn.vkCmdPipelineBarrier(commands, before.stages, after.stages, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

Result<void> TileFlags::resize(const DeviceView& device, VkExtent2D extent) {
  extent_ = extent;
  REPRISE_ASSIGN(flags_, createBuffer(device, count() * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT));
  return {};
}

void TileFlags::clear(const DeviceView& device, VkCommandBuffer commands) const {
  depend(device, commands, {kFlagged.stages | kDrawn.stages, kFlagged.access}, kCleared);
  device.fn.vkCmdFillBuffer(commands, buffer(), 0, VK_WHOLE_SIZE, 0);
  depend(device, commands, kCleared, kFlagged);
}

void TileFlags::makeVisible(const DeviceView& device, VkCommandBuffer commands) const { depend(device, commands, kFlagged, kDrawn); }

void TileFlags::drawTiles(const DeviceView& device, VkCommandBuffer commands) const {
  const VkViewport viewport{0, 0, static_cast<float>(across() * kTilePixels), static_cast<float>(down() * kTilePixels), 0, 1};
  device.fn.vkCmdSetViewport(commands, 0, 1, &viewport);
  device.fn.vkCmdDraw(commands, kVerticesOfATile, count(), 0, 0);
}

std::uint32_t TileFlags::across() const { return tilesIn(extent_.width); }
std::uint32_t TileFlags::down() const { return tilesIn(extent_.height); }
std::uint32_t TileFlags::count() const { return across() * down(); }

}  // namespace reprise

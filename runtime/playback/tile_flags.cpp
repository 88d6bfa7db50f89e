#include "runtime/playback/tile_flags.h"

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

constexpr std::uint32_t kVerticesOfATile = 4;

std::uint32_t tilesIn(std::uint32_t pixels) { return (pixels + kTilePixels - 1) / kTilePixels; }

}  // namespace

Result<void> TileFlags::resize(const DeviceView& device, VkExtent2D extent) {
  extent_ = extent;
  return flags_.reserve(device, count(), FlagReader::kVertexShaders);
}

void TileFlags::drawTiles(const DeviceView& device, VkCommandBuffer commands) const {
  const VkViewport viewport{0, 0, static_cast<float>(across() * kTilePixels), static_cast<float>(down() * kTilePixels), 0, 1};
  device.fn.vkCmdSetViewport(commands, 0, 1, &viewport);
  device.fn.vkCmdDraw(commands, kVerticesOfATile, count(), 0, 0);
}

std::uint32_t TileFlags::across() const { return tilesIn(extent_.width); }
std::uint32_t TileFlags::down() const { return tilesIn(extent_.height); }
std::uint32_t TileFlags::count() const { return across() * down(); }

}  // namespace reprise

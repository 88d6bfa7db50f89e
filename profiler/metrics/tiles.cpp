#include "profiler/metrics/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reprise {
namespace {

constexpr double kLeastCover = 1.0 / 16;
constexpr float kRed = 0.2126f, kGreen = 0.7152f, kBlue = 0.0722f;

int tilesAlong(int pixels) { return std::max(1, (pixels + kMetricTilePixels / 2) / kMetricTilePixels); }

float luminanceOver(const Tile& tile, const DisplayImage& original, const CoverageMask& mask) {
  float red = 0, green = 0, blue = 0;
  visitTile(tile, mask, [&](std::size_t pixel) {
    const float* rgb = &original.rgb[3 * pixel];
    red += rgb[0], green += rgb[1], blue += rgb[2];
  });
  return kRed * red + kGreen * green + kBlue * blue;
}

float gainOf(const Tile& tile, const DisplayImage& original, const CoverageMask& mask) {
  const float sum = luminanceOver(tile, original, mask);
  const float mean = sum / static_cast<float>(tile.covered);
  return mean > 0 ? std::clamp(kMidGrey / mean, 1.0f, kMostGain) : kMostGain;
}

}  // namespace

std::vector<Tile> tilesOf(const DisplayImage& original, const CoverageMask& mask) {
  const int across = tilesAlong(mask.width), down = tilesAlong(mask.height);
  std::vector<Tile> touched, well;
  for (int row = 0; row < down; ++row)
    for (int column = 0; column < across; ++column) {
      Tile tile{column * mask.width / across, row * mask.height / down, (column + 1) * mask.width / across, (row + 1) * mask.height / down, 0, 1};
      for (int y = tile.top; y < tile.bottom; ++y) {
        const std::uint8_t* kinds = &mask.kind[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width)];
        tile.covered += static_cast<std::size_t>(std::count_if(kinds + tile.left, kinds + tile.right, [](std::uint8_t kind) { return kind != 0; }));
      }
      if (tile.covered == 0) continue;
      tile.gain = gainOf(tile, original, mask);
      touched.push_back(tile);
      const double pixels = static_cast<double>(tile.right - tile.left) * (tile.bottom - tile.top);
      if (static_cast<double>(tile.covered) >= kLeastCover * pixels) well.push_back(tile);
    }
  return well.empty() ? touched : well;
}

std::vector<Tile> tilesOf(const MetricInputs& inputs) { return inputs.tiles != nullptr ? *inputs.tiles : tilesOf(*inputs.original, *inputs.mask); }

double tailOf(std::vector<float> values) {
  if (values.empty()) return 0;
  for (const float value : values)
    if (std::isnan(value)) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t rank = (values.size() * 99 + 99) / 100 - 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<std::uint16_t> keptTiles(std::span<const float> values) {
  std::vector<std::uint16_t> kept;
  kept.reserve(values.size());
  for (const float value : values) kept.push_back(static_cast<std::uint16_t>(std::isnan(value) ? 0 : std::clamp(value, 0.0f, 1.0f) * 65535 + 0.5f));
  return kept;
}

}  // namespace reprise

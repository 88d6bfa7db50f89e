// Tiles of about 64×64 pixels, a degree of the visual field at 67 pixels per degree, which is what an eye looks at at once: an error that
// stands in one corner is seen there, however large and however empty the rest of the frame is.
//
// A frame of w×h pixels has max(1, round(w/64)) × max(1, round(h/64)) tiles of nearly equal size. A tile counts if at least 1/16 of its pixels
// are covered; where none has that many, all with a covered pixel count.
//
// The eye adapts to dark content: each tile is also judged at the exposure that brings its mean to mid-grey,
//
//   gain = clamp(0.18 / mean(Y), 1, 4),   Y = 0.2126 R + 0.7152 G + 0.0722 B over its covered pixels of the original
//
// of values as displayed, on which a scenario's exposure works, too; so differences grow with the gain itself. Content of a mean between 0.045 and
// 0.18 is judged as if it had 0.18, darker content at four times what it is. Wrong where exposure clips: highlights of a dark tile are judged as
// if they could go on.
//
// A session's value is the 99th percentile over the tiles of all its frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "profiler/metrics/metrics.h"

namespace reprise {

inline constexpr int kMetricTilePixels = 64;
inline constexpr float kMidGrey = 0.18f, kMostGain = 4;

struct Tile {
  int left = 0, top = 0, right = 0, bottom = 0;  // pixels, the last two beyond the tile
  std::size_t covered = 0;
  float gain = 1;
};

// Those that count.
std::vector<Tile> tilesOf(const DisplayImage& original, const CoverageMask& mask);
std::vector<Tile> tilesOf(const MetricInputs& inputs);

// The 99th percentile of values in [0, 1]; 0 where there are none, NaN where any is.
double tailOf(std::vector<float> values);

// Values of tiles as rows keep them: in units of 1/65535, rounded; NaN as 0 (the frame's own value tells of it).
std::vector<std::uint16_t> keptTiles(std::span<const float> values);

// Sum of square(i) over the components i, three a pixel, of the tile's covered pixels. A fully covered tile is added up in independent sums, so
// that the compiler can vectorize.
template <typename Square>
float sumOver(const Tile& tile, const CoverageMask& mask, Square square);

// Per covered pixel of the tile: visit(index of the pixel).
template <typename Visit>
void visitTile(const Tile& tile, const CoverageMask& mask, Visit visit) {
  for (int y = tile.top; y < tile.bottom; ++y)
    for (int x = tile.left; x < tile.right; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
      if (mask.kind[pixel] != 0) visit(pixel);
    }
}

template <typename Square>
float sumOver(const Tile& tile, const CoverageMask& mask, Square square) {
  constexpr std::size_t kLanes = 16;
  float lanes[kLanes] = {};
  const auto width = static_cast<std::size_t>(mask.width), columns = static_cast<std::size_t>(tile.right - tile.left);
  if (tile.covered != columns * static_cast<std::size_t>(tile.bottom - tile.top)) {
    visitTile(tile, mask, [&](std::size_t pixel) { lanes[0] += square(3 * pixel) + square(3 * pixel + 1) + square(3 * pixel + 2); });
    return lanes[0];
  }
  for (int y = tile.top; y < tile.bottom; ++y) {
    std::size_t i = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(tile.left));
    const std::size_t end = i + 3 * columns;
    for (; i + kLanes <= end; i += kLanes)
      for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] += square(i + lane);
    for (; i < end; ++i) lanes[0] += square(i);
  }
  float sum = 0;
  for (const float lane : lanes) sum += lane;
  return sum;
}

}  // namespace reprise

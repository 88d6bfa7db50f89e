#include "profiler/metrics/blocks.h"

#include <algorithm>
#include <cmath>

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/tiles.h"

namespace reprise {
namespace {

constexpr std::size_t kFewestPairs = 32;

struct Steps {
  float sum = 0;
  std::size_t pairs = 0;
  void add(float step) { sum += step * step, ++pairs; }
  float rms() const { return pairs > 0 ? std::sqrt(sum / static_cast<float>(pairs)) : 0; }
};

float errorAt(const MetricInputs& inputs, std::size_t pixel) {
  const float* original = &inputs.original->rgb[3 * pixel];
  const float* cached = &inputs.cached->rgb[3 * pixel];
  return (cached[0] - original[0] + cached[1] - original[1] + cached[2] - original[2]) / 3;
}

std::vector<float> blocksOf(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (inputs.ages == nullptr) return {};
  const std::vector<std::uint8_t>& ages = *inputs.ages;
  const CoverageMask& mask = *inputs.mask;
  REPRISE_CHECK(ages.size() == mask.kind.size(), ages.size(), mask.kind.size());
  const std::size_t width = static_cast<std::size_t>(mask.width);
  std::vector<float> values;
  for (const Tile& tile : tilesOf(*inputs.original, mask)) {
    Steps unlike, like;
    const auto pair = [&](std::size_t p, std::size_t q) {
      if (mask.kind[q] == 0) return;
      (ages[p] == ages[q] ? like : unlike).add(errorAt(inputs, p) - errorAt(inputs, q));
    };
    visitTile(tile, mask, [&](std::size_t pixel) {
      if (static_cast<int>(pixel % width) + 1 < tile.right) pair(pixel, pixel + 1);
      if (static_cast<int>(pixel / width) + 1 < tile.bottom) pair(pixel, pixel + width);
    });
    if (unlike.pairs < kFewestPairs) continue;
    const float excess = (unlike.rms() - like.rms()) * tile.gain;
    values.push_back(excess < 0 ? 0 : excess > 1 ? 1 : excess);  // NaN stays NaN
  }
  return values;
}

}  // namespace

Metric blocksMetric() {
  return {.name = "blocks",
          .description = "how much more the error steps between neighbours of unlike age than between those of like age in a tile of 64x64 pixels, at the exposure "
                         "that brings a dark one to mid-grey; 99th percentile over tiles",
          .combination = SessionCombination::kTail,
          .adapts = true,
          .tiles = blocksOf};
}

}  // namespace reprise

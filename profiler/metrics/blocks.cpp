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

// By pixel, means over channels: of the original, and of cached − original.
struct Means {
  std::vector<float> original, error;
};

Means meansOf(const MetricInputs& inputs) {
  const std::size_t pixels = inputs.mask->kind.size();
  Means means{std::vector<float>(pixels), std::vector<float>(pixels)};
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  for (std::size_t pixel = 0, i = 0; pixel < pixels; ++pixel, i += 3) {
    means.original[pixel] = (original[i] + original[i + 1] + original[i + 2]) / 3;
    means.error[pixel] = (cached[i] + cached[i + 1] + cached[i + 2]) / 3 - means.original[pixel];
  }
  return means;
}

std::vector<float> blocksOf(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (inputs.ages == nullptr) return {};
  const std::vector<std::uint8_t>& ages = *inputs.ages;
  const CoverageMask& mask = *inputs.mask;
  REPRISE_CHECK(ages.size() == mask.kind.size(), ages.size(), mask.kind.size());
  const std::size_t width = static_cast<std::size_t>(mask.width);
  const Means means = meansOf(inputs);
  std::vector<float> values;
  for (const Tile& tile : tilesOf(inputs)) {
    Steps unlike, like, image;
    const auto pair = [&](std::size_t p, std::size_t q) {
      if (mask.kind[q] == 0) return;
      (ages[p] == ages[q] ? like : unlike).add(means.error[p] - means.error[q]);
      image.add(means.original[p] - means.original[q]);
    };
    visitTile(tile, mask, [&](std::size_t pixel) {
      if (static_cast<int>(pixel % width) + 1 < tile.right) pair(pixel, pixel + 1);
      if (static_cast<int>(pixel / width) + 1 < tile.bottom) pair(pixel, pixel + width);
    });
    if (unlike.pairs < kFewestPairs) continue;
    const float excess = (unlike.rms() - like.rms()) * tile.gain, seen = excess / (1 + image.rms() * tile.gain * 255);
    values.push_back(seen < 0 ? 0 : seen > 1 ? 1 : seen);  // NaN stays NaN
  }
  return values;
}

}  // namespace

Metric blocksMetric() {
  return {.name = "blocks",
          .description = "how much more the error steps between neighbours of unlike age than between those of like age in a tile of 64x64 pixels, less where the "
                         "original steps itself, at the exposure that brings a dark one to mid-grey; 99th percentile over tiles",
          .combination = SessionCombination::kTail,
          .adapts = true,
          .tiles = blocksOf};
}

}  // namespace reprise

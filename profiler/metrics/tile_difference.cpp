#include "profiler/metrics/tile_difference.h"

#include <algorithm>
#include <cmath>

#include "profiler/metrics/covered_pixels.h"
#include "profiler/metrics/tiles.h"

namespace reprise {
namespace {

// square(i): of component i of the image.
template <typename Square>
std::vector<float> rootMeans(const MetricInputs& inputs, Square square) {
  std::vector<float> values;
  for (const Tile& tile : tilesOf(inputs)) {
    const float root = std::sqrt(sumOver(tile, *inputs.mask, square) / (3 * static_cast<float>(tile.covered))) * tile.gain;
    values.push_back(root > 1 ? 1 : root);  // NaN stays NaN
  }
  return values;
}

std::vector<float> differences(const MetricInputs& inputs) {
  checkInputs(inputs);
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  return rootMeans(inputs, [&](std::size_t i) { return (cached[i] - original[i]) * (cached[i] - original[i]); });
}

std::vector<float> changes(const MetricInputs& inputs) {
  checkInputs(inputs);
  if (!inputs.last_original || !inputs.last_cached) return {};
  const float* original = inputs.original->rgb.data();
  const float* cached = inputs.cached->rgb.data();
  const float* last_original = inputs.last_original->rgb.data();
  const float* last_cached = inputs.last_cached->rgb.data();
  return rootMeans(inputs, [&](std::size_t i) {
    const float change = (cached[i] - original[i]) - (last_cached[i] - last_original[i]);
    return change * change;
  });
}

}  // namespace

Metric tileRmsMetric() {
  return {.name = "tile_rms",
          .description = "root of the mean squared difference of a tile of 64x64 pixels, at the exposure that brings a dark one to mid-grey; 99th percentile over tiles",
          .combination = SessionCombination::kTail,
          .adapts = true,
          .tiles = differences};
}

Metric tileFlickerMetric() {
  return {.name = "tile_flicker",
          .description = "root of the mean squared frame-to-frame change of the difference in a tile of 64x64 pixels, at the exposure that brings a dark one to mid-grey; "
                         "99th percentile over tiles",
          .combination = SessionCombination::kTail,
          .adapts = true,
          .tiles = changes};
}

}  // namespace reprise

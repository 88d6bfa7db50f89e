#include "profiler/metrics/quality.h"

#include <array>

namespace reprise {
namespace {

struct Measured {
  double tile_flip, tile_rms, tile_flicker, blocks;
};

Quality level(const std::string& name, int capped_at, const Measured& measured, const std::vector<Threshold>& besides) {
  Quality quality{name, capped_at, {besides}, {besides}};
  for (const Threshold& threshold : {Threshold{"tile_flicker", measured.tile_flicker}, {"blocks", measured.blocks}}) {
    quality.binding.thresholds.push_back(threshold);
    quality.planning.thresholds.push_back(threshold);
  }
  quality.binding.thresholds.push_back({"tile_flip", measured.tile_flip});
  quality.planning.thresholds.push_back({"tile_rms", measured.tile_rms});
  return quality;
}

}  // namespace

std::span<const Quality> qualities() {
  // Besides, at most 1% of the pixels may differ by more than 8/255 where the level promises that nobody sees it.
  static const std::array<Quality, 3> table = {level("imperceptible", 4, {0.067, 0.0111, 0.0112, 0.0012}, {{"over8", 0.01}}),
                                               level("good", 8, {0.085, 0.0175, 0.0184, 0.0025}, {}),
                                               level("draft", 16, {0.100, 0.0267, 0.0272, 0.0048}, {})};
  return table;
}

const Quality* findQuality(const std::string& name) {
  for (const Quality& quality : qualities())
    if (quality.name == name) return &quality;
  return nullptr;
}

}  // namespace reprise

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
  static const std::array<Quality, 3> table = {level("imperceptible", 4, {0.030, 0.010, 0.010, 0.004}, {{"over8", 0.01}}),
                                               level("good", 8, {0.055, 0.019, 0.018, 0.008}, {}),
                                               level("draft", 16, {0.095, 0.035, 0.032, 0.015}, {})};
  return table;
}

const Quality* findQuality(const std::string& name) {
  for (const Quality& quality : qualities())
    if (quality.name == name) return &quality;
  return nullptr;
}

}  // namespace reprise

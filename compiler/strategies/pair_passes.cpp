#include "compiler/strategies/pair_passes.h"

namespace reprise {

bool storesOnceAPair(const Strategy& strategy) { return strategy.caches && strategy.selectable && !strategy.keeps_raw_payload; }

std::vector<PassPlan> passesOfPairs(const Strategy& strategy) {
  PassPlan stored;
  stored.name = "store";
  stored.frame = "shade_misses.frag";
  stored.bodies = {false, true, true};
  stored.frames = PassFrames::kWhollyDue;
  std::vector<PassPlan> passes{stored};
  for (PassPlan pass : strategy.passes) {
    ++pass.rendering;
    pass.writes_cache = false;
    pass.frames = PassFrames::kNotWhollyDue;
    passes.push_back(pass);
  }
  return passes;
}

}  // namespace reprise

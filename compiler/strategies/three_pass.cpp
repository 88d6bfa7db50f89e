// Three passes: hits carry their payload forward, misses compute only the slice, then one tail reads the payload for both.
// (Sitthi-amorn et al. 2008; survey, section 3.2, figure 5.) The tail sees the encoded payload, also for misses.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeThreePassStrategy() {
  PassPlan carry;
  carry.name = "carry";
  carry.frame = "shade_hits.frag";
  carry.bodies = {true, false, false};
  carry.app_targets = false;
  carry.reads_history = true;
  PassPlan slice;
  slice.name = "slice";
  slice.frame = "shade_misses.frag";
  slice.bodies = {false, true, false};
  slice.app_targets = false;
  slice.depth_clear = false;
  PassPlan tail;
  tail.name = "tail";
  tail.rendering = 1;
  tail.frame = "shade_tail.frag";
  tail.bodies = {true, false, true};
  tail.writes_cache = false;
  tail.counts = false;
  tail.reads_current = true;
  tail.depth_clear = false;
  tail.depth = DepthUse::kEqualNoWrite;
  return {"three_pass", "payloads first, carried or computed; then one tail for all pixels", true, true, true, false, true,
          {carry, slice, tail}};
}

}  // namespace reprise

// two_pass, but that a miss flags its object and only flagged objects are drawn again: the device leaves out the others by itself, so nobody
// waits for the flags. Against two_pass it saves the geometry of objects without a miss. It pays with a second rendering, and with
// early depth rejection of the hits: a shader that sets flags runs for hidden fragments too, whose misses then flag in vain.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeTwoPassObjectsStrategy() {
  Strategy strategy = makeTwoPassStrategy();
  strategy.name = "two_pass_objects";
  strategy.description = "hits first; the objects that have misses are drawn again where depth shows no hit";
  PassPlan &hits = strategy.passes[0], &misses = strategy.passes[1];
  hits.flags_draws = true;
  misses.rendering = 1;
  misses.objects = PassObjects::kFlagged;
  return strategy;
}

}  // namespace reprise

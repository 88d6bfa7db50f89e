// A depth prepass, then hits mark stencil and misses fill what is unmarked. Works with any depth comparison.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeTwoPassStencilStrategy() {
  PassPlan prepass;
  prepass.name = "depth";
  prepass.frame = "depth_only.frag";
  prepass.bodies = {false, true, false};
  prepass.app_targets = false;
  prepass.writes_cache = false;
  prepass.counts = false;
  prepass.only_if_discards = true;
  PassPlan hits;
  hits.name = "hits";
  hits.rendering = 1;
  hits.frame = "shade_hits.frag";
  hits.bodies = {true, false, true};
  hits.reads_history = true;
  hits.depth_clear = false;
  hits.depth = DepthUse::kEqualNoWrite;
  hits.stencil = StencilUse::kMarkIfZero;
  PassPlan misses = hits;
  misses.name = "misses";
  misses.frame = "shade_misses.frag";
  misses.bodies = {false, true, true};
  misses.reads_history = false;
  return {"two_pass_stencil", "a depth prepass; hits mark the stencil, misses fill the rest", true, true, false, true, false,
          {prepass, hits, misses}};
}

}  // namespace reprise

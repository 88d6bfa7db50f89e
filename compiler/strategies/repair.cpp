// One draw of the objects: hits are shaded; a miss leaves the shader's inputs in images and flags its tile. A second step shades what is
// left in the flagged tiles, without geometry. Against two passes it saves vertices and rasterization, and pays for the images.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeRepairStrategy() {
  PassPlan hits;
  hits.name = "hits";
  hits.frame = "shade_or_keep.frag";
  hits.bodies = {true, false, true};
  hits.reads_history = true;
  hits.keeps_inputs = true;
  PassPlan misses;
  misses.name = "repair";
  misses.kind = PassKind::kTiles;
  misses.rendering = 1;
  misses.frame = "repair.frag";
  misses.bodies = {false, true, true};
  misses.depth_clear = false;
  misses.depth = DepthUse::kNone;
  return {"repair", "hits are shaded where they are drawn; misses are finished by tiles, without drawing again", true, true, false, false, false,
          {hits, misses}};
}

}  // namespace reprise

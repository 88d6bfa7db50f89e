// Two passes, told apart by depth: hits are drawn first and write depth, misses are discarded; the second draw of the same
// geometry passes the strict depth test only where no hit lies. (Nehab et al. 2007, section 3.4, without their depth shift.)
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeTwoPassStrategy() {
  PassPlan hits;
  hits.name = "hits";
  hits.frame = "shade_hits.frag";
  hits.bodies = {true, false, true};
  hits.reads_history = true;
  PassPlan misses;
  misses.name = "misses";
  misses.frame = "shade_misses.frag";
  misses.bodies = {false, true, true};
  misses.depth_clear = false;
  return {"two_pass", "hits first; the misses are drawn again where depth shows no hit", true, true, true, false, false,
          {hits, misses}};
}

}  // namespace reprise

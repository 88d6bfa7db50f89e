// One pass that branches. The best where hardware skips the path not taken (GPUs); on lavapipe both sides run under a mask.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeBranchStrategy() {
  PassPlan pass;
  pass.name = "branch";
  pass.frame = "branch.frag";
  pass.bodies = {true, true, true};
  pass.reads_history = true;
  return {"branch", "one pass: look up, then run the hit path or the whole shader", true, true, false, false, false, {pass}};
}

}  // namespace reprise

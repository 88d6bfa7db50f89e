// What variants are held against: the original as it is, the original behind a depth prepass, and the tail with a free payload.
#include "compiler/strategies/registry.h"

namespace reprise {

Strategy makeOriginalStrategy() {
  PassPlan pass;
  pass.name = "original";
  pass.source = FragmentSource::kOriginal;
  pass.writes_cache = false;
  return {"original", "the shader as given", false, false, false, false, false, {pass}};
}

Strategy makeOriginalPrepassStrategy() {
  PassPlan prepass;
  prepass.name = "depth";
  prepass.source = FragmentSource::kNone;
  prepass.app_targets = false;
  prepass.writes_cache = false;
  PassPlan shade;
  shade.name = "original";
  shade.rendering = 1;
  shade.source = FragmentSource::kOriginal;
  shade.writes_cache = false;
  shade.depth_clear = false;
  shade.depth = DepthUse::kEqualNoWrite;
  return {"original_prepass", "the shader as given, behind a depth prepass", false, false, false, false, false, {prepass, shade}};
}

Strategy makeTailOnlyStrategy() {
  PassPlan pass;
  pass.name = "tail";
  pass.frame = "tail_only.frag";
  pass.bodies = {true, false, true};
  pass.writes_cache = false;
  return {"tail_only", "the tail alone with a payload that costs nothing: the limit", false, true, false, false, false, {pass}};
}

}  // namespace reprise

// A strategy: how hits and misses are scheduled over the passes of a frame, as data. buildRecipe (build_recipe.h) turns
// it into a recipe; nothing else in the project knows one strategy from another.
//
// A new strategy is one .cpp that describes its passes and one line in registry.cpp; the tests of the laws run over the
// registry.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/package/recipe.h"

namespace reprise {

// Which body of the user's shader a pass's frame calls.
struct Bodies {
  bool hit = false;          // the shader with the payload given
  bool miss = false;         // the whole shader, handing the payload out
  bool colors = true;        // false: colour outputs are hidden, and what only they need is removed
  bool wants = false;        // what tells which guarded values a pixel needs; set by buildRecipe where a payload has guards
};

enum class FragmentSource { kFrame, kOriginal, kNone };

struct PassPlan {
  std::string name;
  PassKind kind = PassKind::kDraw;  // kTiles: of tiles in which `keeps_inputs` flagged misses
  int rendering = 0;
  FragmentSource source = FragmentSource::kFrame;
  std::string frame;           // "branch.frag" of compiler/strategies/glsl
  Bodies bodies;
  bool app_targets = true;     // the application's colour targets are attached
  bool writes_cache = true;    // this frame's history is attached
  bool counts = true;          // of the counting copy: it tells hits from misses
  bool reads_history = false;  // last frame's history
  bool reads_current = false;  // this frame's, written by an earlier rendering
  bool keeps_inputs = false;   // what a miss needs is left for a pass of tiles (kept_inputs.h)
  bool flags_draws = false;    // a miss flags its object, for a pass of kFlagged objects
  PassObjects objects = PassObjects::kAll;
  bool depth_clear = true;
  DepthUse depth = DepthUse::kAsApp;
  StencilUse stencil = StencilUse::kNone;
  PassFrames frames = PassFrames::kAll;
  bool only_if_discards = false;  // fragment code is needed only where the shader discards or writes depth: else depth only
};

struct Strategy {
  std::string name;
  std::string description;          // one sentence
  bool selectable = true;           // false: a reference (original, limit), never a choice
  bool caches = true;               // false: has no payload
  bool rejects_by_depth = false;    // needs a strict depth comparison with writes
  bool needs_stencil = false;
  bool keeps_raw_payload = false;   // a later pass of the frame reads the payload back
  std::vector<PassPlan> passes;
};

// Explicit table: branch, two_pass, two_pass_objects, two_pass_stencil, three_pass, repair, and the references original, original_prepass, tail_only.
std::span<const Strategy> strategies();
// Whether misses are finished without drawing the application's objects again.
bool repairs(const Strategy& strategy);
// Whether misses are drawn again by objects, of those that have any.
bool flagsDraws(const Strategy& strategy);

const Strategy* findStrategy(const std::string& name);

}  // namespace reprise

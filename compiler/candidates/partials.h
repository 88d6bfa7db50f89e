// Parts of sums, products, minima and maxima as payloads: what a chain's terms change with decides how it is split.
//
// For each set of inputs that some of the terms change with: the terms that change with no more than that (the static occluders
// of an occlusion product). And all terms but the heaviest, which goes on being computed in every frame (24 of 25 samples of a
// filter): the one with the largest constant factor where every term has one, else the one that costs most to compute.
#pragma once

#include <vector>

#include "compiler/candidates/enumerate.h"

namespace reprise {

struct Partial {
  Regrouping regrouping;
  std::vector<int> inputs;       // of the kept terms: ascending indices into ShaderAnalysis::inputs
  bool all_but_heaviest = false;
};

// At most so many: each is weighed by a visit to the whole shader.
inline constexpr std::size_t kMostPartials = 256;

// Only of chains that the shader needs and that stand outside of loops.
std::vector<Partial> findPartials(const PreparedShader& shader, const ShaderAnalysis& analysis);

}  // namespace reprise

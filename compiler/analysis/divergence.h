// Where the four lanes of a quad may part before they take a derivative: there it is undefined what the derivative is, and drivers
// answer differently from one surrounding to the next.
//
// Lanes part at a branch whose condition may differ within a quad: it depends on an interpolated varying or on where the fragment is. What
// is the same for a triangle or a draw (flat varyings, FrontFacing, uniforms) parts nobody. Nor does a discard: drivers keep the lane for
// its neighbours, as it is common to sample textures behind an alpha test.
#pragma once

#include <vector>

#include "compiler/analysis/value_graph.h"
#include "compiler/ir/prepare.h"

namespace reprise {

struct Divergence {
  std::vector<int> derivatives;  // nodes, ascending: implicit-LOD samples and derivatives that parted lanes may reach
  std::vector<int> deciders;     // blocks, ascending: whose branches decide which lanes reach them
};

// Looks at `live` nodes only (by node).
Divergence findDivergence(const PreparedShader& shader, const ValueGraph& graph, const std::vector<bool>& live);

}  // namespace reprise

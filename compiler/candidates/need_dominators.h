// For every value at once, what a shader need not compute if that value is given.
//
// A node of the value graph is left out once v is given if every chain of needs from an output or a side effect to it leads through v: if v
// dominates it in the graph of needs (value_graph.h), whose entry needs all roots. So one dominator tree answers for all values what
// neededNodes answers for one. Dominators after Cooper, Harvey, Kennedy, "A Simple, Fast Dominance Algorithm" (2001).
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/analysis/value_graph.h"

namespace reprise {

class NeedDominators {
 public:
  explicit NeedDominators(const ValueGraph& graph);
  // Of a node that the shader needs: the cost of all nodes that are needed through it alone, itself among them; in scalar additions.
  double costThrough(int node) const { return cost_[static_cast<std::size_t>(node)]; }
  // Whether `node` is needed through `through` alone. Both are needed by the shader.
  bool isThrough(int through, int node) const;

 private:
  std::vector<double> cost_;
  std::vector<int> first_, size_;  // by node: where its subtree lies in an order of the dominator tree
};

}  // namespace reprise

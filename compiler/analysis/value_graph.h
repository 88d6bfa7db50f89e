// Who needs whom: the instructions of the entry function as nodes, with data, memory and control dependences.
//
// A node is needed if an output, a side effect or another needed node depends on it; a block is needed if one of its nodes
// is, and then so are the branches that it is control dependent on (control_flow.h). Loads of a local variable that
// is still in memory depend on every store to it.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "compiler/ir/control_flow.h"
#include "compiler/ir/module.h"
#include "compiler/ir/prepare.h"

namespace reprise {

inline constexpr int kNoNode = -1;

struct Node {
  int block = 0;
  int index = 0;                    // in the block
  const Instruction* instruction = nullptr;  // into the prepared module, which must outlive the graph
  std::vector<int> needs;           // data and memory dependences, nodes
  double cost = 0;                  // in scalar additions, times the iterations of the loops around it
  int loop_depth = 0;
  bool root = false;                // output store, side effect
};

struct ValueGraph {
  ControlFlow flow;
  std::vector<Node> nodes;                          // in program order
  std::unordered_map<std::uint32_t, int> node_of;   // by result id
  std::vector<int> terminator_of_block;             // node of each block's terminator
  std::vector<std::vector<int>> nodes_of_block;
};

ValueGraph buildValueGraph(const PreparedShader& shader);

// Nodes needed by the roots (`from` empty) or by the given nodes. Nothing is needed through the nodes `cuts`: their values
// are given. The cut nodes themselves are not marked.
std::vector<bool> neededNodes(const ValueGraph& graph, const std::vector<int>& from, const std::vector<int>& cuts = {});
double costOf(const ValueGraph& graph, const std::vector<bool>& nodes);

// Iterations of a loop: exact where an integer counts by constants to a constant, else kUnknownIterations.
inline constexpr int kUnknownIterations = 8;
int estimateIterations(const Module& module, const Function& function, const ControlFlow& flow, const Loop& loop);

}  // namespace reprise

// The control-flow graph of a function: edges, dominance, post-dominance, control dependence, loops.
//
// Blocks are named by their index in Function::blocks. Dominators after Cooper, Harvey, Kennedy, "A Simple, Fast
// Dominance Algorithm" (2001); control dependence after Ferrante, Ottenstein, Warren (1987): block b depends on the branch
// at the end of block a if one way out of a always leads to b and another may avoid it.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

inline constexpr int kNoBlock = -1;

using Edges = std::vector<std::vector<int>>;  // by block: the blocks at the other ends

struct Loop {
  int header = 0;
  std::vector<bool> contains;  // by block; the blocks that can reach a back edge, header included
};

struct ControlFlow {
  std::unordered_map<std::uint32_t, int> block_of_label;
  Edges successors, predecessors;
  std::vector<bool> reachable;
  std::vector<int> order;                       // reachable blocks in reverse post-order
  std::vector<int> immediate_dominator;         // kNoBlock for the entry and unreachable blocks
  std::vector<std::vector<int>> controllers;    // blocks whose terminating branch this block depends on
  std::vector<Loop> loops;                      // one for each header
};

ControlFlow analyseControlFlow(const Function& function);
bool dominates(const ControlFlow& flow, int dominator, int block);
// Of a graph whose entry is block 0; kNoBlock for the entry and what it does not reach.
std::vector<int> immediateDominators(const Edges& successors, const Edges& predecessors);
// Labels that a terminator may go to.
std::vector<std::uint32_t> targetsOf(const Instruction& terminator);

}  // namespace reprise

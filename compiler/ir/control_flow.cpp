#include "compiler/ir/control_flow.h"

#include <algorithm>

namespace reprise {
namespace {

// Post-order over `edges` from `entry`, without recursion: shaders may be thousands of blocks deep.
std::vector<int> postOrder(const Edges& edges, int entry) {
  std::vector<int> order;
  std::vector<bool> seen(edges.size(), false);
  std::vector<std::pair<int, std::size_t>> stack{{entry, 0}};
  seen[static_cast<std::size_t>(entry)] = true;
  while (!stack.empty()) {
    auto& [block, next] = stack.back();
    const std::vector<int>& out = edges[static_cast<std::size_t>(block)];
    if (next == out.size()) {
      order.push_back(block);
      stack.pop_back();
      continue;
    }
    const int successor = out[next++];
    if (seen[static_cast<std::size_t>(successor)]) continue;
    seen[static_cast<std::size_t>(successor)] = true;
    stack.push_back({successor, 0});
  }
  return order;
}

// Immediate dominators; kNoBlock for the root and what it does not reach.
std::vector<int> dominatorsFrom(const Edges& successors, const Edges& predecessors, int root) {
  const std::vector<int> post_order = postOrder(successors, root);
  std::vector<int> number(successors.size(), -1);
  for (std::size_t i = 0; i < post_order.size(); ++i) number[static_cast<std::size_t>(post_order[i])] = static_cast<int>(i);
  std::vector<int> parent(successors.size(), kNoBlock);
  parent[static_cast<std::size_t>(root)] = root;
  const auto at = [](auto& values, int index) -> auto& { return values[static_cast<std::size_t>(index)]; };
  const auto intersect = [&](int a, int b) {
    while (a != b) {
      while (at(number, a) < at(number, b)) a = at(parent, a);
      while (at(number, b) < at(number, a)) b = at(parent, b);
    }
    return a;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (auto block = post_order.rbegin(); block != post_order.rend(); ++block) {
      if (*block == root) continue;
      int candidate = kNoBlock;
      for (const int predecessor : at(predecessors, *block)) {
        if (at(number, predecessor) < 0 || at(parent, predecessor) == kNoBlock) continue;
        candidate = candidate == kNoBlock ? predecessor : intersect(predecessor, candidate);
      }
      if (candidate == at(parent, *block)) continue;
      at(parent, *block) = candidate;
      changed = true;
    }
  }
  at(parent, root) = kNoBlock;
  return parent;
}

void findLoops(ControlFlow& flow) {
  const auto count = flow.successors.size();
  for (std::size_t header = 0; header < count; ++header) {
    if (!flow.reachable[header]) continue;
    Loop loop{static_cast<int>(header), std::vector<bool>(count, false)};
    std::vector<int> work;
    for (const int tail : flow.predecessors[header])
      if (flow.reachable[static_cast<std::size_t>(tail)] && dominates(flow, static_cast<int>(header), tail)) work.push_back(tail);
    if (work.empty()) continue;
    loop.contains[header] = true;
    while (!work.empty()) {
      const auto block = static_cast<std::size_t>(work.back());
      work.pop_back();
      if (loop.contains[block]) continue;
      loop.contains[block] = true;
      for (const int predecessor : flow.predecessors[block]) work.push_back(predecessor);
    }
    flow.loops.push_back(std::move(loop));
  }
}

void findControllers(ControlFlow& flow, const Function& function) {
  const std::size_t count = function.blocks.size();
  const int exit = static_cast<int>(count);
  Edges forward = flow.successors, backward = flow.predecessors;
  forward.emplace_back();
  backward.emplace_back();
  const auto join = [&](int block) {
    forward[static_cast<std::size_t>(block)].push_back(exit);
    backward.back().push_back(block);
  };
  for (std::size_t block = 0; block < count; ++block)
    if (flow.successors[block].empty()) join(static_cast<int>(block));
  // A loop without a way out reaches no exit; an edge that is never taken gives its blocks post-dominators.
  std::vector<bool> exits(count + 1, false);
  for (const int block : postOrder(backward, exit)) exits[static_cast<std::size_t>(block)] = true;
  for (const Loop& loop : flow.loops)
    if (!exits[static_cast<std::size_t>(loop.header)]) join(loop.header);
  const std::vector<int> post_dominator = dominatorsFrom(backward, forward, exit);
  flow.controllers.assign(count, {});
  for (std::size_t block = 0; block < count; ++block) {
    if (!flow.reachable[block] || forward[block].size() < 2) continue;
    for (const int successor : forward[block])
      for (int runner = successor; runner != exit && runner != kNoBlock && runner != post_dominator[block];
           runner = post_dominator[static_cast<std::size_t>(runner)]) {
        std::vector<int>& controllers = flow.controllers[static_cast<std::size_t>(runner)];
        // Blocks come in order, so that one that is there already is the last.
        if (controllers.empty() || controllers.back() != static_cast<int>(block)) controllers.push_back(static_cast<int>(block));
      }
  }
}

}  // namespace

std::vector<std::uint32_t> targetsOf(const Instruction& terminator) {
  std::vector<std::uint32_t> targets;
  switch (terminator.opcode) {
    case spv::Op::OpBranch: targets = {terminator.word(0)}; break;
    case spv::Op::OpBranchConditional: targets = {terminator.word(1), terminator.word(2)}; break;
    case spv::Op::OpSwitch:
      for (std::size_t i = 1; i < terminator.operands.size(); ++i)
        if (terminator.operands[i].is_id) targets.push_back(terminator.word(i));
      break;
    default: break;
  }
  return targets;
}

bool dominates(const ControlFlow& flow, int dominator, int block) {
  while (block != kNoBlock && block != dominator) block = flow.immediate_dominator[static_cast<std::size_t>(block)];
  return block == dominator;
}

std::vector<int> immediateDominators(const Edges& successors, const Edges& predecessors) {
  return dominatorsFrom(successors, predecessors, 0);
}

ControlFlow analyseControlFlow(const Function& function) {
  ControlFlow flow;
  const std::size_t count = function.blocks.size();
  flow.successors.resize(count);
  flow.predecessors.resize(count);
  for (std::size_t i = 0; i < count; ++i) flow.block_of_label[function.blocks[i].label] = static_cast<int>(i);
  for (std::size_t i = 0; i < count; ++i)
    for (const std::uint32_t label : targetsOf(function.blocks[i].terminator())) {
      const auto target = flow.block_of_label.find(label);
      if (target == flow.block_of_label.end()) continue;
      std::vector<int>& out = flow.successors[i];
      if (std::find(out.begin(), out.end(), target->second) != out.end()) continue;
      out.push_back(target->second);
      flow.predecessors[static_cast<std::size_t>(target->second)].push_back(static_cast<int>(i));
    }
  flow.reachable.assign(count, false);
  flow.order = postOrder(flow.successors, 0);
  std::reverse(flow.order.begin(), flow.order.end());
  for (const int block : flow.order) flow.reachable[static_cast<std::size_t>(block)] = true;
  flow.immediate_dominator = dominatorsFrom(flow.successors, flow.predecessors, 0);
  findLoops(flow);
  findControllers(flow, function);
  return flow;
}

}  // namespace reprise

#include "compiler/candidates/need_dominators.h"

#include <algorithm>
#include <utility>

namespace reprise {
namespace {

constexpr int kUnknown = -1;

// By node, with one more behind them that needs all roots.
std::vector<std::vector<int>> needsOf(const ValueGraph& graph) {
  std::vector<std::vector<int>> needs(graph.nodes.size() + 1);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Node& node = graph.nodes[i];
    needs[i] = node.needs;
    for (const int controller : graph.flow.controllers[static_cast<std::size_t>(node.block)])
      needs[i].push_back(graph.terminator_of_block[static_cast<std::size_t>(controller)]);
    std::erase(needs[i], kNoNode);
    if (node.root) needs.back().push_back(static_cast<int>(i));
  }
  return needs;
}

// Nodes that `entry` reaches, each before those that only it leads to (reverse post-order).
std::vector<int> orderFrom(int entry, const std::vector<std::vector<int>>& needs) {
  std::vector<int> order;
  std::vector<bool> seen(needs.size(), false);
  std::vector<std::pair<int, std::size_t>> path{{entry, 0}};
  seen[static_cast<std::size_t>(entry)] = true;
  while (!path.empty()) {
    auto& [node, next] = path.back();
    const std::vector<int>& out = needs[static_cast<std::size_t>(node)];
    if (next == out.size()) {
      order.push_back(node);
      path.pop_back();
      continue;
    }
    const int target = out[next++];
    if (seen[static_cast<std::size_t>(target)]) continue;
    seen[static_cast<std::size_t>(target)] = true;
    path.push_back({target, 0});
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// By position in the order: the position of the immediate dominator.
std::vector<int> dominatorsOf(const std::vector<int>& order, const std::vector<std::vector<int>>& needs) {
  std::vector<int> position(needs.size(), kUnknown);
  for (std::size_t i = 0; i < order.size(); ++i) position[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  std::vector<std::vector<int>> needed_by(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const int target : needs[static_cast<std::size_t>(order[i])])
      needed_by[static_cast<std::size_t>(position[static_cast<std::size_t>(target)])].push_back(static_cast<int>(i));
  std::vector<int> dominator(order.size(), kUnknown);
  dominator[0] = 0;
  const auto join = [&](int a, int b) {
    while (a != b) {
      while (a > b) a = dominator[static_cast<std::size_t>(a)];
      while (b > a) b = dominator[static_cast<std::size_t>(b)];
    }
    return a;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < order.size(); ++i) {
      int found = kUnknown;
      for (const int from : needed_by[i])
        if (dominator[static_cast<std::size_t>(from)] != kUnknown) found = found == kUnknown ? from : join(found, from);
      if (found == dominator[i]) continue;
      dominator[i] = found;
      changed = true;
    }
  }
  return dominator;
}

}  // namespace

NeedDominators::NeedDominators(const ValueGraph& graph) : cost_(graph.nodes.size() + 1, 0), first_(cost_.size(), 0), size_(cost_.size(), 0) {
  const std::vector<std::vector<int>> needs = needsOf(graph);
  const std::vector<int> order = orderFrom(static_cast<int>(graph.nodes.size()), needs);
  const std::vector<int> dominator = dominatorsOf(order, needs);
  const auto nodeAt = [&](std::size_t position) { return static_cast<std::size_t>(order[position]); };
  for (std::size_t i = order.size(); i-- > 1;) {
    const std::size_t node = nodeAt(i), above = nodeAt(static_cast<std::size_t>(dominator[i]));
    cost_[node] += graph.nodes[node].cost;
    cost_[above] += cost_[node];
    size_[above] += ++size_[node];
  }
  ++size_[nodeAt(0)];
  std::vector<int> next(cost_.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t node = nodeAt(i), above = nodeAt(static_cast<std::size_t>(dominator[i]));
    first_[node] = next[above];
    next[above] += size_[node];
    next[node] = first_[node] + 1;
  }
}

bool NeedDominators::isThrough(int through, int node) const {
  const int first = first_[static_cast<std::size_t>(through)], at = first_[static_cast<std::size_t>(node)];
  return at >= first && at < first + size_[static_cast<std::size_t>(through)];
}

}  // namespace reprise

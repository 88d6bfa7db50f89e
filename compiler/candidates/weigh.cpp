#include "compiler/candidates/weigh.h"

#include <algorithm>

#include "compiler/analysis/operation_cost.h"

namespace reprise {
namespace {

using spv::Op;

// Terms of a regrouped chain, as far as they are computed by the shader: constants are not.
std::vector<int> termNodes(const ValueGraph& graph, const Regrouping& regrouping, bool kept) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < regrouping.kept.size(); ++i) {
    if (regrouping.kept[i] != kept) continue;
    const auto found = graph.node_of.find(regrouping.chain.terms[i].value);
    if (found != graph.node_of.end()) nodes.push_back(found->second);
  }
  return nodes;
}

void addBranches(const ValueGraph& graph, int block, std::vector<int>& nodes) {
  for (const int controller : graph.flow.controllers[static_cast<std::size_t>(block)])
    nodes.push_back(graph.terminator_of_block[static_cast<std::size_t>(controller)]);
}

void unite(std::vector<bool>& to, const std::vector<bool>& from) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] || from[i];
}

// Nodes whose value or execution changes with any of the nodes.
std::vector<bool> dependentNodes(const ValueGraph& graph, const std::vector<int>& sources) {
  std::vector<bool> depends(graph.nodes.size(), false);
  for (const int source : sources) depends[static_cast<std::size_t>(source)] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      if (depends[i]) continue;
      const Node& node = graph.nodes[i];
      const auto isDependent = [&](int other) { return depends[static_cast<std::size_t>(other)]; };
      const auto& controllers = graph.flow.controllers[static_cast<std::size_t>(node.block)];
      if (!std::any_of(node.needs.begin(), node.needs.end(), isDependent) &&
          !std::any_of(controllers.begin(), controllers.end(),
                       [&](int block) { return isDependent(graph.terminator_of_block[static_cast<std::size_t>(block)]); }))
        continue;
      depends[i] = true;
      changed = true;
    }
  }
  return depends;
}

}  // namespace

bool isAlwaysRun(const ControlFlow& flow, const Function& function, int block) {
  std::vector<bool> seen(function.blocks.size(), false);
  std::vector<int> work{0};
  while (!work.empty()) {
    const int current = work.back();
    work.pop_back();
    if (current == block || seen[static_cast<std::size_t>(current)]) continue;
    seen[static_cast<std::size_t>(current)] = true;
    if (function.blocks[static_cast<std::size_t>(current)].terminator().opcode == Op::OpReturn) return false;
    for (const int successor : flow.successors[static_cast<std::size_t>(current)]) work.push_back(successor);
  }
  return true;
}

WeighedPayload weighSingle(const ShaderAnalysis& analysis, const NeedDominators& dominators, const CandidateValue& value) {
  REPRISE_CHECK(!value.regrouping && analysis.live[static_cast<std::size_t>(value.node)], value.node);
  const ValueGraph& graph = analysis.graph;
  std::vector<int> deciding;
  if (value.guard_channel != kNoGuard) addBranches(graph, graph.nodes[static_cast<std::size_t>(value.node)].block, deciding);
  std::vector<bool> decides(graph.nodes.size(), false);
  if (!deciding.empty()) decides = neededNodes(graph, deciding);
  const std::vector<bool> slice = neededNodes(graph, {value.node});
  const auto isLeft = [&](std::size_t node) { return decides[node] || !dominators.isThrough(value.node, static_cast<int>(node)); };
  WeighedPayload weighed;
  weighed.slice_cost = costOf(graph, slice);
  weighed.saved_cost = dominators.costThrough(value.node);
  for (std::size_t i = 0; !deciding.empty() && i < decides.size(); ++i)
    if (decides[i] && analysis.live[i] && dominators.isThrough(value.node, static_cast<int>(i))) weighed.saved_cost -= graph.nodes[i].cost;
  weighed.saved_cost = std::max(0.0, weighed.saved_cost);
  if (!analysis.takes_derivatives) return weighed;
  const bool differentiated = analysis.differentiated[static_cast<std::size_t>(value.node)];
  const std::vector<bool> depends = differentiated ? dependentNodes(graph, {value.node}) : std::vector<bool>(slice.size(), false);
  for (std::size_t i = 0; i < slice.size(); ++i) {
    if (!takesImplicitDerivative(graph.nodes[i].instruction->opcode)) continue;
    weighed.slice_takes_derivatives |= slice[i];
    weighed.tail_takes_derivatives |= depends[i] && analysis.live[i] && isLeft(i);
  }
  return weighed;
}

WeighedPayload weighPayload(const ShaderAnalysis& analysis, const std::vector<CandidateValue>& values) {
  const ValueGraph& graph = analysis.graph;
  std::vector<int> cuts, sliced, left, deciding;
  double joining_cost = 0;  // of joining a kept part with the terms that are left
  for (const CandidateValue& value : values) {
    cuts.push_back(value.node);
    const Node& node = graph.nodes[static_cast<std::size_t>(value.node)];
    if (value.guard_channel != kNoGuard) addBranches(graph, node.block, deciding);
    if (!value.regrouping) {
      sliced.push_back(value.node);
      continue;
    }
    const std::vector<int> kept = termNodes(graph, *value.regrouping, true), rest = termNodes(graph, *value.regrouping, false);
    sliced.insert(sliced.end(), kept.begin(), kept.end());
    left.insert(left.end(), rest.begin(), rest.end());
    addBranches(graph, node.block, left);
    joining_cost += node.cost * static_cast<double>(std::count(value.regrouping->kept.begin(), value.regrouping->kept.end(), false));
  }
  std::vector<bool> tail = neededNodes(graph, {}, cuts);
  if (!left.empty()) unite(tail, neededNodes(graph, left, cuts));
  if (!deciding.empty()) unite(tail, neededNodes(graph, deciding));
  // A sum of constants has no slice; an empty list of starts would mean the roots.
  const std::vector<bool> slice = sliced.empty() ? std::vector<bool>(graph.nodes.size(), false) : neededNodes(graph, sliced);
  WeighedPayload weighed;
  weighed.saved_cost = std::max(0.0, analysis.total_cost - costOf(graph, tail) - joining_cost);
  weighed.slice_cost = costOf(graph, slice);
  if (!analysis.takes_derivatives) return weighed;
  const bool differentiated = std::any_of(cuts.begin(), cuts.end(), [&](int cut) { return analysis.differentiated[static_cast<std::size_t>(cut)]; });
  const std::vector<bool> depends = differentiated ? dependentNodes(graph, cuts) : std::vector<bool>(tail.size(), false);
  for (std::size_t i = 0; i < tail.size(); ++i) {
    if (!takesImplicitDerivative(graph.nodes[i].instruction->opcode)) continue;
    weighed.slice_takes_derivatives |= slice[i];
    weighed.tail_takes_derivatives |= tail[i] && depends[i];
  }
  return weighed;
}

}  // namespace reprise

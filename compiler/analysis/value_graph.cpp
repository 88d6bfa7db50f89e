#include "compiler/analysis/value_graph.h"

#include <algorithm>

#include "compiler/analysis/operation_cost.h"
#include "compiler/ir/trip_count.h"

namespace reprise {
namespace {

using spv::Op;

bool isAccess(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain; }

// The variable behind a pointer: follows access chains and copies.
std::uint32_t rootPointer(const ValueGraph& graph, std::uint32_t pointer) {
  for (auto found = graph.node_of.find(pointer); found != graph.node_of.end(); found = graph.node_of.find(pointer)) {
    const Instruction& instruction = *graph.nodes[static_cast<std::size_t>(found->second)].instruction;
    if (!isAccess(instruction.opcode) && instruction.opcode != Op::OpCopyObject) break;
    pointer = instruction.word(0);
  }
  return pointer;
}

// Components of vector and matrix types, by id. A vector's type stands before the matrix's.
std::unordered_map<std::uint32_t, int> componentsOfTypes(const Module& module) {
  std::unordered_map<std::uint32_t, int> components;
  for (const Instruction& global : module.globals) {
    if (global.opcode == Op::OpTypeVector) components[global.result_id] = static_cast<int>(global.word(1));
    if (global.opcode == Op::OpTypeMatrix) components[global.result_id] = static_cast<int>(global.word(1)) * components[global.word(0)];
  }
  return components;
}

bool isLocalVariable(const ValueGraph& graph, std::uint32_t variable) {
  const auto found = graph.node_of.find(variable);
  return found != graph.node_of.end() &&
         graph.nodes[static_cast<std::size_t>(found->second)].instruction->opcode == Op::OpVariable;
}

// Beyond this, products of nested loops' iterations say nothing and would leave the range of a double.
constexpr double kMostIterations = 1e12;

// Stores to memory, by variable, for the loads that may see them. Each load needs the first store and that needs the others: as
// many loads as stores would else make the square of edges.
void connectMemory(ValueGraph& graph) {
  std::unordered_map<std::uint32_t, std::vector<int>> stores;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (graph.nodes[i].instruction->opcode == Op::OpStore)
      stores[rootPointer(graph, graph.nodes[i].instruction->word(0))].push_back(static_cast<int>(i));
  for (Node& node : graph.nodes) {
    if (node.instruction->opcode != Op::OpLoad) continue;
    const auto found = stores.find(rootPointer(graph, node.instruction->word(0)));
    if (found != stores.end()) node.needs.push_back(found->second.front());
  }
  for (const auto& [variable, of_variable] : stores) {
    std::vector<int>& needs = graph.nodes[static_cast<std::size_t>(of_variable.front())].needs;
    needs.insert(needs.end(), of_variable.begin() + 1, of_variable.end());
  }
}

void connectOperands(ValueGraph& graph) {
  for (Node& node : graph.nodes) {
    for (const Operand& operand : node.instruction->operands) {
      if (!operand.is_id) continue;
      const auto found = graph.node_of.find(operand.words[0]);
      if (found != graph.node_of.end()) node.needs.push_back(found->second);
    }
    if (node.instruction->opcode == Op::OpPhi) {
      // Which way the value came from matters, so the branch that leads here is needed and, with its block, those that lead there.
      for (std::size_t i = 1; i < node.instruction->operands.size(); i += 2) {
        const auto from = graph.flow.block_of_label.find(node.instruction->word(i));
        if (from == graph.flow.block_of_label.end()) continue;
        const int branch = graph.terminator_of_block[static_cast<std::size_t>(from->second)];
        if (branch != kNoNode) node.needs.push_back(branch);
      }
    }
  }
}

}  // namespace

int estimateIterations(const Module& module, const Function& function, const ControlFlow& flow, const Loop& loop) {
  return constantTripCount(module, function, flow, loop).value_or(kUnknownIterations);
}

ValueGraph buildValueGraph(const PreparedShader& shader) {
  const Module& module = shader.module;
  const Function& function = *findFunction(module, shader.entry_function);
  ValueGraph graph;
  graph.flow = analyseControlFlow(function);
  graph.terminator_of_block.assign(function.blocks.size(), kNoNode);
  graph.nodes_of_block.resize(function.blocks.size());
  std::vector<double> iterations(function.blocks.size(), 1);
  std::vector<int> depth(function.blocks.size(), 0);
  for (const Loop& loop : graph.flow.loops) {
    const int count = estimateIterations(module, function, graph.flow, loop);
    for (std::size_t block = 0; block < function.blocks.size(); ++block)
      if (loop.contains[block]) iterations[block] = std::min(iterations[block] * count, kMostIterations), ++depth[block];
  }
  const auto types = resultTypes(module);
  const auto components = componentsOfTypes(module);
  for (std::size_t block = 0; block < function.blocks.size(); ++block) {
    if (!graph.flow.reachable[block]) continue;
    const std::vector<Instruction>& instructions = function.blocks[block].instructions;
    for (std::size_t index = 0; index < instructions.size(); ++index) {
      const Instruction& instruction = instructions[index];
      const int id = static_cast<int>(graph.nodes.size());
      std::uint32_t shaped = instruction.type_id;
      if (instruction.opcode == Op::OpDot)
        if (const auto operand = types.find(instruction.word(0)); operand != types.end()) shaped = operand->second;
      Node node{static_cast<int>(block), static_cast<int>(index), &instruction, {}, 0, depth[block], false};
      const auto shape = components.find(shaped);
      const int width = shape == components.end() ? 1 : shape->second;
      node.cost = instruction.type_id == 0 ? 0 : operationCost(instruction, width) * iterations[block];
      graph.nodes.push_back(std::move(node));
      graph.nodes_of_block[block].push_back(id);
      if (instruction.result_id != 0) graph.node_of[instruction.result_id] = id;
    }
    graph.terminator_of_block[block] = static_cast<int>(graph.nodes.size()) - 1;
  }
  connectOperands(graph);
  connectMemory(graph);
  for (Node& node : graph.nodes)
    node.root = hasSideEffect(node.instruction->opcode) ||
                (node.instruction->opcode == Op::OpStore &&
                 !isLocalVariable(graph, rootPointer(graph, node.instruction->word(0))));
  return graph;
}

std::vector<bool> neededNodes(const ValueGraph& graph, const std::vector<int>& from, const std::vector<int>& cuts) {
  std::vector<bool> needed(graph.nodes.size(), false);
  std::vector<bool> block_needed(graph.nodes_of_block.size(), false);
  std::vector<int> work;
  std::vector<bool> given(graph.nodes.size(), false);
  for (const int cut : cuts) given[static_cast<std::size_t>(cut)] = true;
  const auto need = [&](int node) {
    if (node == kNoNode || given[static_cast<std::size_t>(node)] || needed[static_cast<std::size_t>(node)]) return;
    needed[static_cast<std::size_t>(node)] = true;
    work.push_back(node);
  };
  if (from.empty()) {
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
      if (graph.nodes[i].root) need(static_cast<int>(i));
  }
  for (const int node : from) need(node);
  while (!work.empty()) {
    const Node& node = graph.nodes[static_cast<std::size_t>(work.back())];
    work.pop_back();
    for (const int needed_node : node.needs) need(needed_node);
    const auto block = static_cast<std::size_t>(node.block);
    if (block_needed[block]) continue;
    block_needed[block] = true;
    for (const int controller : graph.flow.controllers[block])
      need(graph.terminator_of_block[static_cast<std::size_t>(controller)]);
  }
  return needed;
}

double costOf(const ValueGraph& graph, const std::vector<bool>& nodes) {
  double cost = 0;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (nodes[i]) cost += graph.nodes[i].cost;
  return cost;
}

}  // namespace reprise

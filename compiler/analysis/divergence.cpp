#include "compiler/analysis/divergence.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <map>
#include <unordered_set>

#include "compiler/analysis/operation_cost.h"

namespace reprise {
namespace {

using spv::Op;

bool endsInvocation(Op opcode) {
  return opcode == Op::OpKill || opcode == Op::OpTerminateInvocation || opcode == Op::OpUnreachable;
}

// By block: every way on ends the invocation.
std::vector<bool> lostBlocks(const Function& function, const ControlFlow& flow) {
  std::vector<bool> lost(function.blocks.size(), false);
  // Against the order of the flow, so that what a block leads to is mostly known; back edges lead to what is not lost.
  for (auto block = flow.order.rbegin(); block != flow.order.rend(); ++block) {
    const auto at = static_cast<std::size_t>(*block);
    const std::vector<int>& successors = flow.successors[at];
    lost[at] = successors.empty() ? endsInvocation(function.blocks[at].terminator().opcode)
                                  : std::all_of(successors.begin(), successors.end(), [&](int next) { return lost[static_cast<std::size_t>(next)]; });
  }
  return lost;
}

// The flow of the lanes that go on: where one way of two is lost, the other is taken.
ControlFlow flowOfSurvivors(const Function& function, const ControlFlow& flow) {
  const std::vector<bool> lost = lostBlocks(function, flow);
  const auto isLost = [&](std::uint32_t label) {
    const auto found = flow.block_of_label.find(label);
    return found != flow.block_of_label.end() && lost[static_cast<std::size_t>(found->second)];
  };
  Function survivors;
  survivors.blocks = function.blocks;
  for (Block& block : survivors.blocks) {
    Instruction& terminator = block.instructions.back();
    if (terminator.opcode != Op::OpBranchConditional) continue;
    const std::uint32_t taken = terminator.word(1), otherwise = terminator.word(2);
    if (isLost(taken) == isLost(otherwise)) continue;
    terminator = makeInstruction(Op::OpBranch, 0, 0, {idOperand(isLost(taken) ? otherwise : taken)});
  }
  return analyseControlFlow(survivors);
}

// An input that lanes of one quad may see differently.
bool isVarying(const Module& module, const Instruction& variable) {
  if (variable.opcode != Op::OpVariable || static_cast<spv::StorageClass>(variable.word(0)) != spv::StorageClass::Input) return false;
  const auto built_in = decorationOf(module, variable.result_id, spv::Decoration::BuiltIn);
  if (!built_in) return !decorationOf(module, variable.result_id, spv::Decoration::Flat);
  switch (static_cast<spv::BuiltIn>(*built_in)) {
    case spv::BuiltIn::FrontFacing:
    case spv::BuiltIn::PrimitiveId:
    case spv::BuiltIn::Layer:
    case spv::BuiltIn::ViewportIndex:
    case spv::BuiltIn::ViewIndex:
    case spv::BuiltIn::SubgroupSize: return false;
    default: return true;
  }
}

std::unordered_set<std::uint32_t> varyingVariables(const Module& module) {
  std::unordered_set<std::uint32_t> variables;
  for (const Instruction& global : module.globals)
    if (isVarying(module, global)) variables.insert(global.result_id);
  return variables;
}

std::uint32_t rootOf(const ValueGraph& graph, std::uint32_t pointer) {
  for (auto found = graph.node_of.find(pointer); found != graph.node_of.end(); found = graph.node_of.find(pointer)) {
    const Instruction& instruction = *graph.nodes[static_cast<std::size_t>(found->second)].instruction;
    if (instruction.opcode != Op::OpAccessChain && instruction.opcode != Op::OpInBoundsAccessChain) break;
    pointer = instruction.word(0);
  }
  return pointer;
}

// Differs by itself, whatever it is made from.
bool varies(const std::unordered_set<std::uint32_t>& variables, const ValueGraph& graph, const Instruction& instruction) {
  switch (instruction.opcode) {
    case Op::OpLoad: return variables.count(rootOf(graph, instruction.word(0))) != 0;
    case Op::OpIsHelperInvocationEXT: return true;
    case Op::OpExtInst:
      return instruction.word(1) >= GLSLstd450InterpolateAtCentroid && instruction.word(1) <= GLSLstd450InterpolateAtOffset;
    default: return false;
  }
}

// By node: lanes of a quad may differ in it, or in whether they come by.
std::vector<bool> variesInQuad(const Module& module, const ValueGraph& graph, const ControlFlow& flow) {
  std::vector<std::vector<int>> users(graph.nodes.size());
  std::vector<int> work;
  std::vector<bool> varying(graph.nodes.size(), false);
  const std::unordered_set<std::uint32_t> variables = varyingVariables(module);
  const auto mark = [&](int node) {
    if (varying[static_cast<std::size_t>(node)]) return;
    varying[static_cast<std::size_t>(node)] = true;
    work.push_back(node);
  };
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Node& node = graph.nodes[i];
    for (const int needed : node.needs) users[static_cast<std::size_t>(needed)].push_back(static_cast<int>(i));
    if (node.instruction->opcode == Op::OpStore || node.instruction->result_id == 0)
      for (const int controller : flow.controllers[static_cast<std::size_t>(node.block)])
        users[static_cast<std::size_t>(graph.terminator_of_block[static_cast<std::size_t>(controller)])].push_back(static_cast<int>(i));
    if (varies(variables, graph, *node.instruction)) mark(static_cast<int>(i));
  }
  while (!work.empty()) {
    const int node = work.back();
    work.pop_back();
    for (const int user : users[static_cast<std::size_t>(node)]) mark(user);
  }
  return varying;
}

// By block: its branch decides, at first hand or through others, whether `block` runs.
std::vector<bool> controllersAbove(const ControlFlow& flow, int block) {
  std::vector<bool> above(flow.controllers.size(), false);
  std::vector<int> work{block};
  while (!work.empty()) {
    const auto at = static_cast<std::size_t>(work.back());
    work.pop_back();
    for (const int controller : flow.controllers[at]) {
      if (above[static_cast<std::size_t>(controller)]) continue;
      above[static_cast<std::size_t>(controller)] = true;
      work.push_back(controller);
    }
  }
  return above;
}

}  // namespace

Divergence findDivergence(const PreparedShader& shader, const ValueGraph& graph, const std::vector<bool>& live) {
  Divergence divergence;
  std::vector<std::size_t> derivatives;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (live[i] && takesImplicitDerivative(graph.nodes[i].instruction->opcode)) derivatives.push_back(i);
  if (derivatives.empty()) return divergence;
  const ControlFlow flow = flowOfSurvivors(*findFunction(shader.module, shader.entry_function), graph.flow);
  const std::vector<bool> varying = variesInQuad(shader.module, graph, flow);
  const std::size_t blocks = graph.nodes_of_block.size();
  std::map<int, std::vector<bool>> above;  // by block: derivatives often share theirs
  std::vector<bool> decides(blocks, false);
  for (const std::size_t derivative : derivatives) {
    const auto [of_block, is_new] = above.try_emplace(graph.nodes[derivative].block);
    if (is_new) of_block->second = controllersAbove(flow, of_block->first);
    bool parted = false;
    for (std::size_t block = 0; block < blocks; ++block)
      parted = parted || (of_block->second[block] && varying[static_cast<std::size_t>(graph.terminator_of_block[block])]);
    if (!parted) continue;
    divergence.derivatives.push_back(static_cast<int>(derivative));
    for (std::size_t block = 0; block < blocks; ++block) decides[block] = decides[block] || of_block->second[block];
  }
  for (std::size_t block = 0; block < blocks; ++block)
    if (decides[block]) divergence.deciders.push_back(static_cast<int>(block));
  return divergence;
}

}  // namespace reprise

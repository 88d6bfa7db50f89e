#include "compiler/analysis/deciding_inputs.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace reprise {
namespace {

using spv::Decoration;
using spv::Op;
using spv::StorageClass;

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();

bool leavesLoop(const ControlFlow& flow, int block) {
  const auto at = static_cast<std::size_t>(block);
  return std::any_of(flow.loops.begin(), flow.loops.end(), [&](const Loop& loop) {
    return loop.contains[at] && std::any_of(flow.successors[at].begin(), flow.successors[at].end(),
                                            [&](int next) { return !loop.contains[static_cast<std::size_t>(next)]; });
  });
}

// Indices into the analysis's inputs, each once.
std::vector<int> decidingIndices(const ShaderAnalysis& analysis) {
  const ValueGraph& graph = analysis.graph;
  std::vector<int> found;
  const auto addAll = [&](bool strong) {
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const Node& node = graph.nodes[i];
      const Op opcode = node.instruction->opcode;
      if (opcode != Op::OpBranchConditional && opcode != Op::OpSwitch) continue;
      if ((opcode == Op::OpSwitch || leavesLoop(graph.flow, node.block)) != strong) continue;
      for (const int input : analysis.inputs_of[i])
        if (std::find(found.begin(), found.end(), input) == found.end()) found.push_back(input);
    }
  };
  addAll(true);
  addAll(false);
  return found;
}

std::optional<DecidingInput> varyingOf(const Module& module, const Instruction& variable) {
  const auto location = decorationOf(module, variable.result_id, Decoration::Location);
  const Instruction* type = findGlobal(module, findGlobal(module, variable.type_id)->word(1));
  if (!location || (type->opcode != Op::OpTypeVector && type->opcode != Op::OpTypeInt && type->opcode != Op::OpTypeFloat)) return std::nullopt;
  DecidingInput input;
  input.location = *location;
  input.component = decorationOf(module, variable.result_id, Decoration::Component).value_or(0);
  if (type->opcode == Op::OpTypeVector) {
    input.components = type->word(1);
    type = findGlobal(module, type->word(0));
  }
  input.is_integer = type->opcode == Op::OpTypeInt;
  return input;
}

DecidingInput rangeOf(const Module& module, const Instruction& variable, std::optional<std::uint32_t> member) {
  DecidingInput input;
  const bool pushed = static_cast<StorageClass>(variable.word(0)) == StorageClass::PushConstant;
  input.kind = pushed ? DecidingInput::Kind::kPushConstants : DecidingInput::Kind::kBlock;
  input.set = decorationOf(module, variable.result_id, Decoration::DescriptorSet).value_or(0);
  input.binding = decorationOf(module, variable.result_id, Decoration::Binding).value_or(0);
  input.end_byte = kEnd;
  const std::uint32_t block = findGlobal(module, variable.type_id)->word(1);
  if (!member) return input;
  const auto first = memberDecorationOf(module, block, *member, Decoration::Offset);
  if (!first) return input;
  input.first_byte = *first;
  // Up to the member that follows in memory, which need not be the next one.
  const Instruction* type = findGlobal(module, block);
  for (std::uint32_t other = 0; type->opcode == Op::OpTypeStruct && other < type->operands.size(); ++other)
    if (const auto offset = memberDecorationOf(module, block, other, Decoration::Offset); offset && *offset > *first)
      input.end_byte = std::min(input.end_byte, *offset);
  return input;
}

}  // namespace

std::vector<DecidingInput> decidingInputs(const PreparedShader& shader, const ShaderAnalysis& analysis) {
  std::vector<DecidingInput> result;
  for (const int index : decidingIndices(analysis)) {
    const InputOrigin& origin = analysis.origins[static_cast<std::size_t>(index)];
    const Instruction* variable = findGlobal(shader.module, origin.variable);
    const InputKind kind = analysis.inputs[static_cast<std::size_t>(index)].kind;
    std::optional<DecidingInput> input;
    if (kind == InputKind::kVarying) input = varyingOf(shader.module, *variable);
    if (kind == InputKind::kUniform || kind == InputKind::kBuffer) input = rangeOf(shader.module, *variable, origin.member);
    if (input && std::find(result.begin(), result.end(), *input) == result.end()) result.push_back(*input);
  }
  return result;
}

}  // namespace reprise

#include "compiler/candidates/enumerate.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <spirv-tools/libspirv.h>

#include "compiler/analysis/operation_cost.h"
#include "compiler/candidates/prune.h"

namespace reprise {
namespace {

using spv::Op;

std::string operationName(const Instruction& instruction) {
  const char* name = spvOpcodeString(static_cast<std::uint32_t>(instruction.opcode));
  return name == nullptr ? "operation" : name;
}

bool dependsOnPixel(const Candidate& candidate, const ShaderAnalysis& analysis) {
  return std::any_of(candidate.inputs.begin(), candidate.inputs.end(), [&](int input) {
    const InputKind kind = analysis.inputs[static_cast<std::size_t>(input)].kind;
    return kind == InputKind::kVarying || kind == InputKind::kBuiltIn;
  });
}

// Nodes whose value or execution changes with node `source`.
std::vector<bool> dependents(const ValueGraph& graph, int source) {
  std::vector<bool> depends(graph.nodes.size(), false);
  depends[static_cast<std::size_t>(source)] = true;
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

bool tailTakesDerivativesOf(const ShaderAnalysis& analysis, int node, const std::vector<bool>& tail) {
  if (!analysis.takes_derivatives) return false;
  const std::vector<bool> depends = dependents(analysis.graph, node);
  for (std::size_t i = 0; i < tail.size(); ++i)
    if (tail[i] && depends[i] && takesImplicitDerivative(analysis.graph.nodes[i].instruction->opcode)) return true;
  return false;
}

// Whether every path from the entry to a normal end runs through the node's block.
bool alwaysComputed(const ShaderAnalysis& analysis, const Function& function, int block) {
  const ControlFlow& flow = analysis.graph.flow;
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

struct Surroundings {
  const PreparedShader& shader;
  const ShaderAnalysis& analysis;
  const Function& function;
};

DropReason firstReason(const Candidate& candidate, const Surroundings& around) {
  const Node& node = around.analysis.graph.nodes[static_cast<std::size_t>(candidate.node)];
  if (candidate.channels == 0)
    return {"type.unsupported", "only 16- and 32-bit floats, 32-bit integers, booleans and vectors of them can be kept"};
  if (node.loop_depth > 0)
    return {"place.loop", "it is computed inside a loop, so one pixel has many of it"};
  if (!dependsOnPixel(candidate, around.analysis))
    return {"value.uniform", "it is the same for all pixels"};
  if (onlyRearranges(node.instruction->opcode) || node.instruction->opcode == Op::OpLoad)
    return {"value.rearranged", "it only loads or rearranges other values"};
  return {};
}

void describe(Candidate& candidate, const Surroundings& around, const std::vector<SourceFile>& sources) {
  const Node& node = around.analysis.graph.nodes[static_cast<std::size_t>(candidate.node)];
  const auto named = around.shader.named.find(candidate.value);
  if (named != around.shader.named.end()) candidate.name = named->second.name;
  candidate.operation = operationName(*node.instruction);
  candidate.place = placeOf(around.shader, candidate.value, sources);
  candidate.id = (candidate.name.empty() ? candidate.operation : candidate.name) + "@" +
                 std::filesystem::path(candidate.place.file).filename().string() + ":" + std::to_string(candidate.place.line);
}

void weigh(Candidate& candidate, const Surroundings& around) {
  const ShaderAnalysis& analysis = around.analysis;
  const std::vector<bool> tail = neededNodes(analysis.graph, {}, candidate.node);
  candidate.saved_cost = analysis.total_cost - costOf(analysis.graph, tail);
  candidate.share = analysis.total_cost > 0 ? candidate.saved_cost / analysis.total_cost : 0;
  const std::vector<bool> slice = neededNodes(analysis.graph, {candidate.node});
  candidate.slice_cost = costOf(analysis.graph, slice);
  for (std::size_t i = 0; i < slice.size(); ++i)
    candidate.slice_takes_derivatives |= slice[i] && takesImplicitDerivative(analysis.graph.nodes[i].instruction->opcode);
  if (tailTakesDerivativesOf(analysis, candidate.node, tail))
    candidate.dropped = {"tail.derivative",
                         "the rest of the shader takes derivatives of what depends on it, and a neighbouring pixel's payload "
                         "may belong to another surface"};
}

// Ids must tell candidates apart: the second of a kind on one line gets "#2".
void makeIdsUnique(std::vector<Candidate>& candidates) {
  std::unordered_map<std::string, int> seen;
  for (Candidate& candidate : candidates)
    if (const int count = ++seen[candidate.id]; count > 1) candidate.id += "#" + std::to_string(count);
}

}  // namespace

std::vector<Candidate> enumerateCandidates(const PreparedShader& shader, const ShaderAnalysis& analysis,
                                           const std::vector<SourceFile>& sources, const CandidateOptions& options) {
  const Surroundings around{shader, analysis, *findFunction(shader.module, shader.entry_function)};
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < analysis.graph.nodes.size(); ++i) {
    const Node& node = analysis.graph.nodes[i];
    const Op opcode = node.instruction->opcode;
    if (!analysis.live[i] || node.instruction->type_id == 0 || opcode == Op::OpVariable || opcode == Op::OpAccessChain ||
        opcode == Op::OpInBoundsAccessChain)
      continue;
    Candidate candidate;
    candidate.value = node.instruction->result_id;
    candidate.node = static_cast<int>(i);
    const PayloadType type = payloadType(shader.module, node.instruction->type_id);
    candidate.channels = type.channels;
    candidate.scalar = type.scalar;
    candidate.type = type.channels > 0 ? nameOf(type) : "other";
    candidate.inputs = analysis.inputs_of[i];
    describe(candidate, around, sources);
    candidate.dropped = firstReason(candidate, around);
    if (candidate.kept() && analysis.refusal) candidate.dropped = {analysis.refusal->code, analysis.refusal->message};
    if (candidate.kept()) {
      candidate.conditional = !alwaysComputed(analysis, around.function, node.block);
      weigh(candidate, around);
    }
    candidates.push_back(std::move(candidate));
  }
  makeIdsUnique(candidates);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.saved_cost > b.saved_cost; });
  pruneCandidates(candidates, analysis.total_cost, options);
  std::stable_partition(candidates.begin(), candidates.end(), [](const Candidate& candidate) { return candidate.kept(); });
  return candidates;
}

std::vector<std::string> inputNames(const Candidate& candidate, const ShaderAnalysis& analysis) {
  std::vector<std::string> names;
  for (const int input : candidate.inputs) {
    const InputSource& source = analysis.inputs[static_cast<std::size_t>(input)];
    names.push_back(std::string(nameOf(source.kind)) + " " + source.name);
  }
  return names;
}

}  // namespace reprise

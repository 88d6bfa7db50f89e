#include "compiler/analysis/analyse.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "compiler/analysis/buffer_reads.h"
#include "compiler/analysis/components.h"
#include "compiler/analysis/operation_cost.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

const char* builtInName(std::uint32_t built_in) {
  switch (static_cast<spv::BuiltIn>(built_in)) {
    case spv::BuiltIn::FragCoord: return "FragCoord";
    case spv::BuiltIn::FrontFacing: return "FrontFacing";
    case spv::BuiltIn::PointCoord: return "PointCoord";
    case spv::BuiltIn::SampleId: return "SampleId";
    case spv::BuiltIn::SamplePosition: return "SamplePosition";
    case spv::BuiltIn::SampleMask: return "SampleMask";
    case spv::BuiltIn::HelperInvocation: return "HelperInvocation";
    case spv::BuiltIn::PrimitiveId: return "PrimitiveId";
    case spv::BuiltIn::Layer: return "Layer";
    case spv::BuiltIn::ViewportIndex: return "ViewportIndex";
    case spv::BuiltIn::SubgroupSize: return "SubgroupSize";
    case spv::BuiltIn::SubgroupLocalInvocationId: return "SubgroupLocalInvocationId";
    case spv::BuiltIn::SubgroupEqMask:
    case spv::BuiltIn::SubgroupGeMask:
    case spv::BuiltIn::SubgroupGtMask:
    case spv::BuiltIn::SubgroupLeMask:
    case spv::BuiltIn::SubgroupLtMask: return "SubgroupMask";
    default: return "built-in";
  }
}

class InputFinder {
 public:
  InputFinder(const PreparedShader& shader, ShaderAnalysis& analysis) : module_(shader.module), analysis_(analysis) {
    for (const Instruction& global : module_.globals) globals_[global.result_id] = &global;
  }

  // The input that a load through `pointer` reads; none for local variables and constants.
  std::optional<int> inputOf(std::uint32_t pointer) {
    std::uint32_t member = 0;  // the index into the variable itself: that of the innermost chain
    const Instruction* variable = globalOf(pointer);
    while (variable == nullptr) {
      const auto found = analysis_.graph.node_of.find(pointer);
      if (found == analysis_.graph.node_of.end()) return std::nullopt;
      const Instruction& instruction = *analysis_.graph.nodes[static_cast<std::size_t>(found->second)].instruction;
      if (instruction.opcode != Op::OpAccessChain && instruction.opcode != Op::OpInBoundsAccessChain) return std::nullopt;
      if (instruction.operands.size() > 1) member = instruction.word(1);
      pointer = instruction.word(0);
      variable = globalOf(pointer);
    }
    if (variable->opcode != Op::OpVariable) return std::nullopt;
    const auto [known, is_new] = found_.try_emplace({pointer, member});
    if (is_new) known->second = describe(*variable, member);
    return known->second;
  }

  bool tooMany() const { return too_many_; }

 private:
  const Instruction* globalOf(std::uint32_t id) const {
    const auto found = globals_.find(id);
    return found == globals_.end() ? nullptr : found->second;
  }

  std::optional<int> describe(const Instruction& variable, std::uint32_t member) {
    if (analysis_.inputs.size() == kMostInputs) {
      too_many_ = true;
      return std::nullopt;
    }
    const std::uint32_t id = variable.result_id;
    switch (static_cast<StorageClass>(variable.word(0))) {
      case StorageClass::Input:
        if (const auto built_in = decorationOf(module_, id, spv::Decoration::BuiltIn))
          return intern({InputKind::kBuiltIn, builtInName(*built_in)}, {id, {}});
        return intern({InputKind::kVarying, orId(nameOf(module_, id), id)}, {id, {}});
      case StorageClass::Uniform:
      case StorageClass::PushConstant: return intern({InputKind::kUniform, memberName(variable, member)}, {id, constantOf(member)});
      case StorageClass::UniformConstant: return intern({InputKind::kTexture, orId(nameOf(module_, id), id)}, {id, {}});
      case StorageClass::StorageBuffer: return intern({InputKind::kBuffer, orId(nameOf(module_, id), id)}, {id, {}});
      default: return std::nullopt;
    }
  }

  std::string memberName(const Instruction& variable, std::uint32_t member) {
    const Instruction* pointer = globalOf(variable.type_id);
    const std::uint32_t block = pointer->word(1);
    std::string name = nameOf(module_, block);
    if (name.empty()) name = orId(nameOf(module_, variable.result_id), variable.result_id);
    const auto index = constantOf(member);
    return index ? name + "." + memberNameOf(module_, block, *index) : name;
  }

  std::optional<std::uint32_t> constantOf(std::uint32_t id) const {
    const Instruction* constant = globalOf(id);
    if (constant == nullptr || constant->opcode != Op::OpConstant) return std::nullopt;
    return constant->word(0);
  }

  static std::string orId(const std::string& name, std::uint32_t id) {
    return name.empty() ? "%" + std::to_string(id) : name;
  }

  int intern(const InputSource& source, const InputOrigin& origin) {
    const auto found = std::find(analysis_.inputs.begin(), analysis_.inputs.end(), source);
    if (found != analysis_.inputs.end()) return static_cast<int>(found - analysis_.inputs.begin());
    analysis_.inputs.push_back(source);
    analysis_.origins.push_back(origin);
    return static_cast<int>(analysis_.inputs.size()) - 1;
  }

  const Module& module_;
  ShaderAnalysis& analysis_;
  std::unordered_map<std::uint32_t, const Instruction*> globals_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<int>> found_;  // by variable and member
  bool too_many_ = false;
};

// Nodes that a node changes with: what it needs and, where it takes effect only if its block runs, the branches that lead there.
// A pure value is the same wherever it is computed.
std::vector<int> influencesOf(const ValueGraph& graph, const Node& node) {
  std::vector<int> influences = node.needs;
  if (node.instruction->opcode != Op::OpStore && node.instruction->result_id != 0) return influences;
  for (const int controller : graph.flow.controllers[static_cast<std::size_t>(node.block)])
    influences.push_back(graph.terminator_of_block[static_cast<std::size_t>(controller)]);
  return influences;
}

std::vector<std::vector<int>> influencesOfAll(const ValueGraph& graph) {
  std::vector<std::vector<int>> influences;
  influences.reserve(graph.nodes.size());
  for (const Node& node : graph.nodes) influences.push_back(influencesOf(graph, node));
  return influences;
}

// The least fixed point: nodes that influence one another change with the same inputs.
void propagateInputs(ShaderAnalysis& analysis) {
  const std::vector<std::vector<int>> influences = influencesOfAll(analysis.graph);
  for (const std::vector<int>& component : componentsBehindFirst(influences)) {
    std::vector<int> inputs, merged;
    const auto add = [&](const std::vector<int>& more) {
      merged.clear();
      std::set_union(inputs.begin(), inputs.end(), more.begin(), more.end(), std::back_inserter(merged));
      inputs.swap(merged);
    };
    for (const int node : component) {
      add(analysis.inputs_of[static_cast<std::size_t>(node)]);
      for (const int influence : influences[static_cast<std::size_t>(node)]) add(analysis.inputs_of[static_cast<std::size_t>(influence)]);
    }
    for (const int node : component) analysis.inputs_of[static_cast<std::size_t>(node)] = inputs;
  }
}

Error refused(const std::string& code, const std::string& message) {
  return {ErrorKind::kRefused, code, message, {}};
}

bool usesCapability(const Module& module, std::initializer_list<spv::Capability> wanted) {
  for (const Instruction& capability : module.capabilities)
    for (const spv::Capability one : wanted)
      if (capability.word(0) == static_cast<std::uint32_t>(one)) return true;
  return false;
}

// Reads a varying through its pointer, as a load does.
bool interpolatesElsewhere(const Instruction& instruction) {
  return instruction.opcode == Op::OpExtInst && instruction.word(1) >= GLSLstd450InterpolateAtCentroid &&
         instruction.word(1) <= GLSLstd450InterpolateAtOffset;
}

// A mask of no samples drops the fragment.
bool writesSampleMask(const Module& module) {
  constexpr auto kSampleMask = static_cast<std::uint32_t>(spv::BuiltIn::SampleMask);
  return std::any_of(module.globals.begin(), module.globals.end(), [&](const Instruction& global) {
    return global.opcode == Op::OpVariable && static_cast<StorageClass>(global.word(0)) == StorageClass::Output &&
           decorationOf(module, global.result_id, spv::Decoration::BuiltIn) == kSampleMask;
  });
}

bool isAtomic(Op opcode) {
  return (opcode >= Op::OpAtomicLoad && opcode <= Op::OpAtomicXor) || opcode == Op::OpAtomicFlagTestAndSet ||
         opcode == Op::OpAtomicFlagClear || opcode == Op::OpAtomicFAddEXT || opcode == Op::OpAtomicFMinEXT ||
         opcode == Op::OpAtomicFMaxEXT;
}

bool readsSubgroup(Op opcode) {
  return (opcode >= Op::OpGroupNonUniformElect && opcode <= Op::OpGroupNonUniformQuadSwap) ||
         (opcode >= Op::OpSubgroupBallotKHR && opcode <= Op::OpSubgroupReadInvocationKHR) ||
         opcode == Op::OpGroupNonUniformPartitionNV;
}

Error subgroupRefusal() {
  return refused("shader.subgroup", "the shader reads its subgroup or its neighbours in it, which differ from pass to pass");
}

bool usesHelperInvocation(const ShaderAnalysis& analysis) {
  return std::any_of(analysis.inputs.begin(), analysis.inputs.end(), [](const InputSource& input) {
           return input.kind == InputKind::kBuiltIn && input.name == "HelperInvocation";
         }) ||
         std::any_of(analysis.graph.nodes.begin(), analysis.graph.nodes.end(),
                     [](const Node& node) { return node.instruction->opcode == Op::OpIsHelperInvocationEXT; });
}

std::optional<Error> findRefusal(const PreparedShader& shader, const ShaderAnalysis& analysis) {
  const Module& module = shader.module;
  if (usesCapability(module, {spv::Capability::FragmentShaderPixelInterlockEXT,
                              spv::Capability::FragmentShaderSampleInterlockEXT}))
    return refused("shader.interlock", "the shader orders fragments by interlock, which a second pass would break");
  for (std::size_t i = 0; i < analysis.graph.nodes.size(); ++i) {
    const Instruction& instruction = *analysis.graph.nodes[i].instruction;
    if (instruction.opcode == Op::OpImageWrite || instruction.opcode == Op::OpCopyMemory ||
        isAtomic(instruction.opcode))
      return refused("shader.side_effects", "the shader writes to memory, which a cached pass would drop or repeat");
    if (readsSubgroup(instruction.opcode)) return subgroupRefusal();
    if (instruction.opcode == Op::OpStore && analysis.graph.nodes[i].root) {
      std::uint32_t pointer = instruction.word(0);
      for (auto found = analysis.graph.node_of.find(pointer); found != analysis.graph.node_of.end();
           found = analysis.graph.node_of.find(pointer)) {
        const Instruction& chain = *analysis.graph.nodes[static_cast<std::size_t>(found->second)].instruction;
        if (chain.opcode != Op::OpAccessChain && chain.opcode != Op::OpInBoundsAccessChain) break;
        pointer = chain.word(0);
      }
      const Instruction* variable = findGlobal(module, pointer);
      if (variable == nullptr || variable->opcode != Op::OpVariable ||
          static_cast<StorageClass>(variable->word(0)) != StorageClass::Output)
        return refused("shader.side_effects", "the shader writes to memory, which a cached pass would drop or repeat");
    }
  }
  for (const InputSource& input : analysis.inputs)
    if (input.kind == InputKind::kBuiltIn && input.name.starts_with("Subgroup")) return subgroupRefusal();
  if (usesHelperInvocation(analysis))
    return refused("shader.helper_invocation",
                   "the shader asks whether it runs for a helper pixel, which differs from pass to pass");
  if (usesCapability(module, {spv::Capability::SampleRateShading}))
    return refused("shader.sample_rate", "the shader runs once per sample; version 1 caches at one sample per pixel");
  for (const InputSource& input : analysis.inputs)
    if (input.kind == InputKind::kBuiltIn && (input.name == "SampleId" || input.name == "SamplePosition"))
      return refused("shader.sample_rate", "the shader runs once per sample; version 1 caches at one sample per pixel");
  return std::nullopt;
}

// Discards, and stores to built-in outputs: depth, sample mask, stencil reference.
bool decidesCoverage(const Module& module, const ValueGraph& graph, std::size_t node) {
  const Instruction& instruction = *graph.nodes[node].instruction;
  if (instruction.opcode == Op::OpKill || instruction.opcode == Op::OpTerminateInvocation ||
      instruction.opcode == Op::OpDemoteToHelperInvocation)
    return true;
  if (instruction.opcode != Op::OpStore || !graph.nodes[node].root) return false;
  std::uint32_t pointer = instruction.word(0);
  for (auto found = graph.node_of.find(pointer); found != graph.node_of.end(); found = graph.node_of.find(pointer))
    pointer = graph.nodes[static_cast<std::size_t>(found->second)].instruction->word(0);
  return decorationOf(module, pointer, spv::Decoration::BuiltIn).has_value();
}

// By node: whether a node that `wanted` names depends on it. Those themselves do not count, unless for one another.
template <typename Wanted>
std::vector<bool> neededBy(const ValueGraph& graph, const Wanted& wanted) {
  std::vector<int> operands;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (!wanted(i)) continue;
    const Node& node = graph.nodes[i];
    operands.insert(operands.end(), node.needs.begin(), node.needs.end());
    for (const int controller : graph.flow.controllers[static_cast<std::size_t>(node.block)])
      operands.push_back(graph.terminator_of_block[static_cast<std::size_t>(controller)]);
  }
  return operands.empty() ? std::vector<bool>(graph.nodes.size(), false) : neededNodes(graph, operands);
}

}  // namespace

const char* nameOf(InputKind kind) {
  constexpr std::array<const char*, 5> kNames = {"varying", "built-in", "uniform", "texture", "buffer"};
  return kNames[static_cast<std::size_t>(kind)];
}

ShaderAnalysis analyse(const PreparedShader& shader) {
  ShaderAnalysis analysis;
  analysis.graph = buildValueGraph(shader);
  const ValueGraph& graph = analysis.graph;
  analysis.inputs_of.resize(graph.nodes.size());
  InputFinder finder(shader, analysis);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Instruction& instruction = *graph.nodes[i].instruction;
    const bool interpolates = interpolatesElsewhere(instruction);
    if (instruction.opcode != Op::OpLoad && !interpolates) continue;
    if (const auto input = finder.inputOf(instruction.word(interpolates ? 2 : 0))) analysis.inputs_of[i] = {*input};
  }
  propagateInputs(analysis);
  analysis.live = neededNodes(graph, {});
  analysis.total_cost = costOf(graph, analysis.live);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const Op opcode = graph.nodes[i].instruction->opcode;
    analysis.takes_derivatives |= analysis.live[i] && takesImplicitDerivative(opcode);
    analysis.discards |= opcode == Op::OpKill || opcode == Op::OpTerminateInvocation || opcode == Op::OpDemoteToHelperInvocation;
  }
  analysis.discards |= writesSampleMask(shader.module);
  analysis.differentiated = neededBy(graph, [&](std::size_t i) {
    return analysis.live[i] && takesImplicitDerivative(graph.nodes[i].instruction->opcode);
  });
  const std::vector<bool> buffers = readsOfBuffers(shader.module, graph);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) analysis.derivatives_read_buffers |= buffers[i] && analysis.differentiated[i];
  analysis.divergence = findDivergence(shader, graph, analysis.live);
  analysis.decides_coverage = neededBy(graph, [&](std::size_t i) { return decidesCoverage(shader.module, graph, i); });
  analysis.refusal = findRefusal(shader, analysis);
  if (finder.tooMany() && !analysis.refusal)
    analysis.refusal = refused("shader.limit", "the shader reads more than " + std::to_string(kMostInputs) +
                                                   " different inputs; at most so many are told apart");
  return analysis;
}

}  // namespace reprise

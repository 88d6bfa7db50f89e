#include "compiler/candidates/value_hashes.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "runtime/base/hash.h"

namespace reprise {
namespace {

using spv::Op;

std::string wordsText(const Operand& operand) {
  std::string text;
  for (const std::uint32_t word : operand.words) text += "." + std::to_string(word);
  return text;
}

bool isPointerStep(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain; }

class ValueHasher {
 public:
  ValueHasher(const PreparedShader& shader, const ShaderAnalysis& analysis, bool with_constants)
      : module_(shader.module), graph_(analysis.graph), function_(*findFunction(shader.module, shader.entry_function)),
        with_constants_(with_constants), hashes_(graph_.nodes.size(), "?") {
    for (const auto* section : {&module_.globals, &module_.imports})
      for (const Instruction& global : *section) global_[global.result_id] = &global;
    for (const Instruction& name : module_.names)
      if (name.opcode == Op::OpName) name_[name.word(0)] = stringOf(name.operands[1]);
    for (const Instruction& annotation : module_.annotations) readDecoration(annotation);
    for (const Node& node : graph_.nodes)
      if (node.instruction->result_id != 0) type_of_[node.instruction->result_id] = node.instruction->type_id;
  }

  std::vector<std::string> run() {
    for (int pass = 0; pass < kHashPasses; ++pass) {
      control_.assign(function_.blocks.size(), std::nullopt);
      for (std::size_t i = 0; i < hashes_.size(); ++i) hashes_[i] = contentHash(textOf(graph_.nodes[i]));
    }
    return std::move(hashes_);
  }

 private:
  void readDecoration(const Instruction& annotation) {
    if (annotation.opcode != Op::OpDecorate) return;
    const auto decoration = static_cast<spv::Decoration>(annotation.word(1));
    const bool changes_results = decoration == spv::Decoration::NoContraction || decoration == spv::Decoration::RelaxedPrecision ||
                                 decoration == spv::Decoration::NonUniform || decoration == spv::Decoration::Flat ||
                                 decoration == spv::Decoration::NoPerspective || decoration == spv::Decoration::Centroid ||
                                 decoration == spv::Decoration::Sample || decoration == spv::Decoration::BuiltIn ||
                                 decoration == spv::Decoration::SpecId;
    const bool names_it = decoration == spv::Decoration::Location || decoration == spv::Decoration::Binding ||
                          decoration == spv::Decoration::DescriptorSet;
    std::string text = "@" + std::to_string(annotation.word(1));
    if (annotation.operands.size() > 2) text += wordsText(annotation.operands[2]);
    if (changes_results) decorations_[annotation.word(0)] += text;
    if (names_it) places_[annotation.word(0)] += text;
  }

  std::string nameOrPlace(std::uint32_t id) const {
    const auto name = name_.find(id);
    if (name != name_.end() && !name->second.empty()) return name->second;
    const auto place = places_.find(id);
    return place == places_.end() ? "" : place->second;
  }

  // A named struct counts by its name: what is read of it counts by the names of members (memberText).
  std::string structText(const Instruction& type) {
    const auto name = name_.find(type.result_id);
    if (name != name_.end() && !name->second.empty()) return "struct " + name->second;
    return operandsText(type);
  }

  std::string operandsText(const Instruction& instruction) {
    std::string text = "op" + std::to_string(static_cast<int>(instruction.opcode)) + "(";
    for (const Operand& operand : instruction.operands) text += (operand.is_id ? globalText(operand.words[0]) : wordsText(operand)) + ",";
    return text + ")";
  }

  // Types, constants, variables and imports of the module.
  std::string globalText(std::uint32_t id) {
    if (const auto known = global_text_.find(id); known != global_text_.end()) return known->second;
    const auto found = global_.find(id);
    if (found == global_.end()) return "?";
    const Instruction& global = *found->second;
    global_text_[id] = "^";  // of a pointer to its own struct
    std::string text;
    if (global.opcode == Op::OpTypeStruct) {
      text = structText(global);
    } else if (global.opcode == Op::OpVariable) {
      const auto storage = static_cast<spv::StorageClass>(global.word(0));
      const bool local = storage == spv::StorageClass::Private || storage == spv::StorageClass::Function;
      text = "variable " + globalText(global.type_id) + (local ? "" : nameOrPlace(id)) + decorationsOf(id);
    } else if (global.type_id != 0 && !with_constants_) {
      text = "constant " + globalText(global.type_id);
    } else {
      text = (global.type_id != 0 ? globalText(global.type_id) : "") + operandsText(global) + decorationsOf(id);
    }
    return global_text_[id] = text;
  }

  std::string decorationsOf(std::uint32_t id) const {
    const auto found = decorations_.find(id);
    return found == decorations_.end() ? "" : found->second;
  }

  std::string idText(std::uint32_t id) {
    if (const auto node = graph_.node_of.find(id); node != graph_.node_of.end()) return hashes_[static_cast<std::size_t>(node->second)];
    if (const auto block = graph_.flow.block_of_label.find(id); block != graph_.flow.block_of_label.end()) return "";
    return globalText(id);
  }

  // What decides that the block runs: the branches that it depends on and the side that leads to it.
  const std::string& controlOf(int block) {
    std::optional<std::string>& known = control_[static_cast<std::size_t>(block)];
    if (known) return *known;
    known = "";
    std::vector<std::string> parts;
    for (const int controller : graph_.flow.controllers[static_cast<std::size_t>(block)]) {
      const std::size_t terminator = static_cast<std::size_t>(graph_.terminator_of_block[static_cast<std::size_t>(controller)]);
      const std::vector<std::uint32_t> targets = targetsOf(*graph_.nodes[terminator].instruction);
      std::string side;
      for (std::size_t i = 0; i < targets.size(); ++i)
        if (dominates(graph_.flow, graph_.flow.block_of_label.at(targets[i]), block)) side += std::to_string(i) + ",";
      parts.push_back(hashes_[terminator] + ":" + side);
    }
    std::sort(parts.begin(), parts.end());
    std::string text;
    for (const std::string& part : parts) text += part + ";";
    return *(control_[static_cast<std::size_t>(block)] = contentHash(text));
  }

  std::string phiText(const Node& node) {
    std::vector<std::string> ways;
    for (std::size_t i = 0; i + 1 < node.instruction->operands.size(); i += 2) {
      const auto from = static_cast<std::size_t>(graph_.flow.block_of_label.at(node.instruction->word(i + 1)));
      const std::vector<std::uint32_t> targets = targetsOf(function_.blocks[from].terminator());
      const std::uint32_t here = function_.blocks[static_cast<std::size_t>(node.block)].label;
      std::string way = idText(node.instruction->word(i)) + "<" + controlOf(static_cast<int>(from));
      if (targets.size() > 1)
        way += std::to_string(std::find(targets.begin(), targets.end(), here) - targets.begin()) +
               hashes_[static_cast<std::size_t>(graph_.terminator_of_block[from])];
      ways.push_back(std::move(way));
    }
    std::sort(ways.begin(), ways.end());
    std::string text;
    for (const std::string& way : ways) text += way + "|";
    return text;
  }

  // The literal index of a struct's member counts by the member's name.
  std::string memberText(std::uint32_t type, std::uint32_t member) const {
    const std::string name = memberNameOf(module_, type, member);
    return name.empty() ? "#" + std::to_string(member) : "." + name;
  }

  std::uint32_t innerType(std::uint32_t type, std::uint32_t member) const {
    const auto found = global_.find(type);
    if (found == global_.end()) return 0;
    const Instruction& global = *found->second;
    if (global.opcode == Op::OpTypeStruct) return member < global.operands.size() ? global.word(member) : 0;
    if (global.opcode == Op::OpTypePointer) return global.word(1);
    const bool holds_equals = global.opcode == Op::OpTypeArray || global.opcode == Op::OpTypeRuntimeArray ||
                              global.opcode == Op::OpTypeMatrix || global.opcode == Op::OpTypeVector;
    return holds_equals ? global.word(0) : 0;
  }

  bool isStruct(std::uint32_t type) const {
    const auto found = global_.find(type);
    return found != global_.end() && found->second->opcode == Op::OpTypeStruct;
  }

  std::string chainText(const Instruction& chain, std::size_t first, std::uint32_t type) {
    std::string text = idText(chain.word(0));
    for (std::size_t i = first; i < chain.operands.size(); ++i) {
      std::uint32_t member = 0;
      const Operand& operand = chain.operands[i];
      if (!operand.is_id) member = operand.words[0];
      else if (const auto constant = global_.find(operand.words[0]); constant != global_.end() && constant->second->opcode == Op::OpConstant)
        member = constant->second->word(0);
      if (isStruct(type)) text += memberText(type, member);
      else text += operand.is_id ? "[" + idText(operand.words[0]) + "]" : wordsText(operand);
      type = innerType(type, member);
    }
    return text;
  }

  std::uint32_t typeOf(std::uint32_t id) const {
    if (const auto node = type_of_.find(id); node != type_of_.end()) return node->second;
    const auto global = global_.find(id);
    return global == global_.end() ? 0 : global->second->type_id;
  }

  std::string textOf(const Node& node) {
    const Instruction& instruction = *node.instruction;
    std::string text = std::to_string(static_cast<int>(instruction.opcode)) + "/";
    if (instruction.type_id != 0) text += globalText(instruction.type_id);
    text += decorationsOf(instruction.result_id) + "/";
    if (instruction.opcode == Op::OpPhi) {
      text += phiText(node);
    } else if (isPointerStep(instruction.opcode)) {
      text += chainText(instruction, 1, innerType(typeOf(instruction.word(0)), 0));
    } else if (instruction.opcode == Op::OpCompositeExtract) {
      text += chainText(instruction, 1, typeOf(instruction.word(0)));
    } else {
      for (const Operand& operand : instruction.operands) text += (operand.is_id ? idText(operand.words[0]) : wordsText(operand)) + ",";
    }
    std::vector<std::string> needs;
    for (const int need : node.needs) needs.push_back(hashes_[static_cast<std::size_t>(need)]);
    std::sort(needs.begin(), needs.end());
    for (const std::string& need : needs) text += "+" + need;
    return text + "/" + controlOf(node.block);
  }

  const Module& module_;
  const ValueGraph& graph_;
  const Function& function_;
  bool with_constants_;
  std::vector<std::string> hashes_;
  std::vector<std::optional<std::string>> control_;  // by block, in this pass
  std::unordered_map<std::uint32_t, const Instruction*> global_;
  std::unordered_map<std::uint32_t, std::string> name_, global_text_, decorations_, places_;
  std::unordered_map<std::uint32_t, std::uint32_t> type_of_;
};

}  // namespace

std::vector<std::string> hashValues(const PreparedShader& shader, const ShaderAnalysis& analysis, bool with_constants) {
  return ValueHasher(shader, analysis, with_constants).run();
}

}  // namespace reprise

#include "compiler/candidates/slice_terms.h"

#include <fmt/format.h>
#include <spirv-tools/libspirv.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <optional>
#include <set>
#include <unordered_map>

#include "compiler/ir/payload_type.h"

namespace reprise {
namespace {

using spv::Op;

// Of GLSL.std.450, by number from 1.
constexpr const char* kFunctionNames[] = {
    "Round", "RoundEven", "Trunc", "FAbs", "SAbs", "FSign", "SSign", "Floor", "Ceil", "Fract", "Radians", "Degrees", "Sin", "Cos", "Tan", "Asin",
    "Acos", "Atan", "Sinh", "Cosh", "Tanh", "Asinh", "Acosh", "Atanh", "Atan2", "Pow", "Exp", "Log", "Exp2", "Log2", "Sqrt", "InverseSqrt",
    "Determinant", "MatrixInverse", "Modf", "ModfStruct", "FMin", "UMin", "SMin", "FMax", "UMax", "SMax", "FClamp", "UClamp", "SClamp", "FMix",
    "IMix", "Step", "SmoothStep", "Fma", "Frexp", "FrexpStruct", "Ldexp", "PackSnorm4x8", "PackUnorm4x8", "PackSnorm2x16", "PackUnorm2x16",
    "PackHalf2x16", "PackDouble2x32", "UnpackSnorm2x16", "UnpackUnorm2x16", "UnpackHalf2x16", "UnpackSnorm4x8", "UnpackUnorm4x8",
    "UnpackDouble2x32", "Length", "Distance", "Cross", "Normalize", "FaceForward", "Reflect", "Refract", "FindILsb", "FindSMsb", "FindUMsb",
    "InterpolateAtCentroid", "InterpolateAtSample", "InterpolateAtOffset", "NMin", "NMax", "NClamp"};

std::string literalText(const Operand& operand) {
  std::string text;
  for (const std::uint32_t word : operand.words) text += "." + std::to_string(word);
  return text;
}

std::string opcodeName(Op opcode) {
  const char* name = spvOpcodeString(static_cast<std::uint32_t>(opcode));
  return name == nullptr ? "Op" + std::to_string(static_cast<int>(opcode)) : name;
}

// Without the characters that terms are spelled with.
std::string plainName(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '.' && c != '[' && c != ']' && c != '-' && c != ' ') c = '_';
  return name;
}

std::string floatText(float value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

bool isPointerStep(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain; }

class TermBuilder {
 public:
  TermBuilder(const PreparedShader& shader, const ShaderAnalysis& analysis)
      : module_(shader.module), analysis_(analysis), graph_(analysis.graph), function_(*findFunction(shader.module, shader.entry_function)) {
    for (const auto* section : {&module_.globals, &module_.imports})
      for (const Instruction& global : *section) global_[global.result_id] = &global;
  }

  SliceTerms valueTerms(int node) {
    const std::set<int> branches = branchesOf(graph_.nodes[static_cast<std::size_t>(node)].block);
    if (branches.empty()) {
      nodeTerm(node);
    } else {
      const int when = newTerm("When");
      addPart(when, nodeTerm(node));
      for (const int branch : branches) addPart(when, nodeTerm(branch));
    }
    return finished();
  }

  SliceTerms chainTerms(const Chain& chain, const std::vector<bool>& kept) {
    const int whole = newTerm(nameOf(chain.kind));
    if (const auto root = graph_.node_of.find(chain.root); root != graph_.node_of.end()) terms_[0].node = root->second;
    for (std::size_t i = 0; i < chain.terms.size(); ++i) {
      if (!kept[i]) continue;
      int term = idTerm(chain.terms[i].value);
      if (chain.terms[i].negative) {
        const int minus = newTerm("minus");
        addPart(minus, term);
        term = minus;
      }
      addPart(whole, term);
    }
    return finished();
  }

 private:
  int newTerm(std::string head) {
    terms_.push_back({std::move(head)});
    return static_cast<int>(terms_.size()) - 1;
  }

  void addPart(int term, int part) { terms_[static_cast<std::size_t>(term)].parts.push_back(part); }

  // Parts are filled in one by one, so that no depth of a shader is a depth of calls.
  SliceTerms finished() {
    for (std::size_t next = 0; next < waiting_.size(); ++next) fill(waiting_[next]);
    return std::move(terms_);
  }

  int nodeTerm(int node) {
    const auto [known, is_new] = term_of_node_.try_emplace(node, static_cast<int>(terms_.size()));
    if (is_new) {
      newTerm("");
      terms_.back().node = node;
      waiting_.push_back(node);
    }
    return known->second;
  }

  int idTerm(std::uint32_t id) {
    if (const auto node = graph_.node_of.find(id); node != graph_.node_of.end()) return nodeTerm(node->second);
    const auto [known, is_new] = term_of_global_.try_emplace(id, static_cast<int>(terms_.size()));
    if (is_new) addGlobal(id);
    return known->second;
  }

  void addGlobal(std::uint32_t id) {
    const int term = newTerm(kUnknownHead);
    const auto found = global_.find(id);
    if (found == global_.end()) return;
    const Instruction& global = *found->second;
    terms_[static_cast<std::size_t>(term)].head = globalHead(global);
    if (global.opcode == Op::OpConstantComposite || global.opcode == Op::OpSpecConstantComposite)
      for (const Operand& operand : global.operands) {
        const int part = idTerm(operand.words[0]);
        addPart(term, part);
      }
  }

  std::string globalHead(const Instruction& global) const {
    switch (global.opcode) {
      case Op::OpConstantTrue: return "true";
      case Op::OpConstantFalse: return "false";
      case Op::OpConstantNull: return "null";
      case Op::OpUndef: return "undefined";
      case Op::OpConstant: return numberText(global);
      case Op::OpConstantComposite:
      case Op::OpSpecConstantComposite: return typeName(global.type_id).value_or("composite");
      case Op::OpSpecConstant: return "specialization " + plainName(nameOf(module_, global.result_id)) + " " + numberText(global);
      case Op::OpVariable: return variableName(global);
      default: return plainName(opcodeName(global.opcode) + " " + nameOf(module_, global.result_id));
    }
  }

  std::string numberText(const Instruction& constant) const {
    const auto type = global_.find(constant.type_id);
    const std::uint32_t word = constant.word(0);
    if (type == global_.end() || constant.operands[0].words.size() != 1) return "number" + literalText(constant.operands[0]);
    if (type->second->opcode == Op::OpTypeFloat) return type->second->word(0) == 32 ? floatText(std::bit_cast<float>(word)) : fmt::format("0x{:x}h", word);
    if (type->second->opcode != Op::OpTypeInt) return "number" + literalText(constant.operands[0]);
    return type->second->word(1) == 1 ? std::to_string(static_cast<std::int32_t>(word)) : std::to_string(word) + "u";
  }

  std::optional<std::string> typeName(std::uint32_t type_id) const {
    const PayloadType type = payloadType(module_, type_id);
    return type.channels > 0 ? std::optional(nameOf(type)) : std::nullopt;
  }

  // As the analysis names it; of a block the member that is read.
  std::optional<std::string> inputName(std::uint32_t variable, std::optional<std::uint32_t> member) const {
    for (std::size_t i = 0; i < analysis_.origins.size(); ++i)
      if (analysis_.origins[i].variable == variable && (!analysis_.origins[i].member || analysis_.origins[i].member == member))
        return plainName(std::string(nameOf(analysis_.inputs[i].kind)) + " " + analysis_.inputs[i].name);
    return std::nullopt;
  }

  // Names of locals do not count.
  std::string variableName(const Instruction& variable) const {
    const auto storage = static_cast<spv::StorageClass>(variable.word(0));
    if (storage == spv::StorageClass::Private || storage == spv::StorageClass::Function) return "local";
    return inputName(variable.result_id, std::nullopt).value_or(plainName("variable " + nameOf(module_, variable.result_id)));
  }

  std::uint32_t innerType(std::uint32_t type, std::uint32_t member) const {
    const auto found = global_.find(type);
    if (found == global_.end()) return 0;
    const Instruction& global = *found->second;
    switch (global.opcode) {
      case Op::OpTypeStruct: return member < global.operands.size() ? global.word(member) : 0;
      case Op::OpTypePointer: return global.word(1);
      case Op::OpTypeArray:
      case Op::OpTypeRuntimeArray:
      case Op::OpTypeMatrix:
      case Op::OpTypeVector: return global.word(0);
      default: return 0;
    }
  }

  bool isStruct(std::uint32_t type) const {
    const auto found = global_.find(type);
    return found != global_.end() && found->second->opcode == Op::OpTypeStruct;
  }

  std::uint32_t typeOfNode(std::uint32_t id) const {
    const auto node = graph_.node_of.find(id);
    return node == graph_.node_of.end() ? 0 : graph_.nodes[static_cast<std::size_t>(node->second)].instruction->type_id;
  }

  // What a pointer points at, by name; what is indexed with is a part.
  void fillPointer(std::uint32_t pointer, SliceTerm& filled) {
    const auto node = graph_.node_of.find(pointer);
    if (node == graph_.node_of.end()) {
      const auto global = global_.find(pointer);
      filled.head = global == global_.end() ? kUnknownHead : globalHead(*global->second);
      return;
    }
    const Instruction& chain = *graph_.nodes[static_cast<std::size_t>(node->second)].instruction;
    if (!isPointerStep(chain.opcode)) {
      filled.head = "Load";
      filled.parts.push_back(nodeTerm(node->second));
      return;
    }
    const auto base = global_.find(chain.word(0));
    if (base == global_.end()) filled.parts.push_back(idTerm(chain.word(0)));
    std::uint32_t type = innerType(base == global_.end() ? typeOfNode(chain.word(0)) : base->second->type_id, 0);
    std::optional<std::string> named;
    std::string path;
    for (std::size_t i = 1; i < chain.operands.size(); ++i) {
      const auto index = global_.find(chain.word(i));
      const std::optional<std::uint32_t> constant =
          index != global_.end() && index->second->opcode == Op::OpConstant ? std::optional(index->second->word(0)) : std::nullopt;
      if (i == 1 && isStruct(type) && constant && (named = inputName(chain.word(0), constant))) {
      } else if (isStruct(type)) {
        path += "." + memberNameOf(module_, type, constant.value_or(0));
      } else if (constant) {
        path += "[" + std::to_string(*constant) + "]";
      } else {
        path += "[]";
        filled.parts.push_back(idTerm(chain.word(i)));
      }
      type = innerType(type, constant.value_or(0));
    }
    filled.head = named.value_or(base == global_.end() ? "local" : globalHead(*base->second)) + plainName(path);
  }

  std::set<int> branchesOf(int block) const {
    std::set<int> branches;
    for (const int controller : graph_.flow.controllers[static_cast<std::size_t>(block)])
      branches.insert(graph_.terminator_of_block[static_cast<std::size_t>(controller)]);
    return branches;
  }

  void fillPhi(const Instruction& phi, SliceTerm& filled) {
    std::set<int> branches;
    for (std::size_t i = 0; i + 1 < phi.operands.size(); i += 2) {
      filled.parts.push_back(idTerm(phi.word(i)));
      const int from = graph_.flow.block_of_label.at(phi.word(i + 1));
      branches.merge(branchesOf(from));
      if (targetsOf(function_.blocks[static_cast<std::size_t>(from)].terminator()).size() > 1)
        branches.insert(graph_.terminator_of_block[static_cast<std::size_t>(from)]);
    }
    for (const int branch : branches) filled.parts.push_back(nodeTerm(branch));
  }

  void fillOperands(const Instruction& instruction, SliceTerm& filled) {
    std::size_t first = 0;
    if (instruction.opcode == Op::OpExtInst) {
      const std::uint32_t number = instruction.word(1);
      if (number >= 1 && number <= std::size(kFunctionNames)) filled.head = kFunctionNames[number - 1];
      else filled.head += literalText(instruction.operands[1]);
      first = 2;
    }
    for (std::size_t i = first; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      if (!operand.is_id) {
        if (instruction.opcode != Op::OpBranchConditional) filled.head += literalText(operand);  // there: weights
      } else if (!graph_.flow.block_of_label.contains(operand.words[0])) {
        filled.parts.push_back(idTerm(operand.words[0]));
      }
    }
  }

  void fill(int node) {
    const Node& place = graph_.nodes[static_cast<std::size_t>(node)];
    const Instruction& instruction = *place.instruction;
    SliceTerm filled{opcodeName(instruction.opcode), {}, node};
    if (instruction.opcode == Op::OpPhi) {
      fillPhi(instruction, filled);
    } else if (instruction.opcode == Op::OpLoad) {
      fillPointer(instruction.word(0), filled);
      if (isInputHead(filled.head)) return put(std::move(filled));
    } else if (isPointerStep(instruction.opcode)) {
      fillPointer(instruction.result_id, filled);
    } else {
      fillOperands(instruction, filled);
    }
    if (const std::optional<std::string> type = instruction.type_id == 0 ? std::nullopt : typeName(instruction.type_id); type && *type != "float")
      filled.head += ":" + *type;
    addMemory(place, filled);
    put(std::move(filled));
  }

  // What a load from memory needs besides its operands.
  void addMemory(const Node& place, SliceTerm& filled) {
    if (place.instruction->opcode == Op::OpPhi) return;
    for (const int need : place.needs) {
      const std::uint32_t id = graph_.nodes[static_cast<std::size_t>(need)].instruction->result_id;
      const auto& operands = place.instruction->operands;
      const bool is_operand = id != 0 && std::any_of(operands.begin(), operands.end(), [&](const Operand& one) { return one.is_id && one.words[0] == id; });
      if (!is_operand) filled.parts.push_back(nodeTerm(need));
    }
  }

  void put(SliceTerm filled) { terms_[static_cast<std::size_t>(term_of_node_.at(filled.node))] = std::move(filled); }

  const Module& module_;
  const ShaderAnalysis& analysis_;
  const ValueGraph& graph_;
  const Function& function_;
  std::unordered_map<std::uint32_t, const Instruction*> global_;
  SliceTerms terms_;
  std::unordered_map<int, int> term_of_node_;
  std::unordered_map<std::uint32_t, int> term_of_global_;
  std::vector<int> waiting_;  // nodes whose terms have no parts yet
};

}  // namespace

bool isConstantHead(const std::string& head) {
  const std::size_t first = head.starts_with('-') ? 1 : 0;
  const bool number = first < head.size() && std::isdigit(static_cast<unsigned char>(head[first])) != 0;
  return number || head == "true" || head == "false" || head == "null" || head.substr(first) == "inf" || head.substr(first) == "nan";
}

bool isInputHead(const std::string& head) {
  for (const InputKind kind : {InputKind::kVarying, InputKind::kBuiltIn, InputKind::kUniform, InputKind::kTexture, InputKind::kBuffer})
    if (head.starts_with(std::string(nameOf(kind)) + " ")) return true;
  return false;
}

SliceTerms termsOfValue(const PreparedShader& shader, const ShaderAnalysis& analysis, int node) { return TermBuilder(shader, analysis).valueTerms(node); }

SliceTerms termsOfChain(const PreparedShader& shader, const ShaderAnalysis& analysis, const Chain& chain, const std::vector<bool>& kept) {
  return TermBuilder(shader, analysis).chainTerms(chain, kept);
}

}  // namespace reprise

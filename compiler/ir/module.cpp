#include "compiler/ir/module.h"

#include <cstring>

namespace reprise {

Operand idOperand(std::uint32_t id) { return {true, {id}}; }

Operand literalOperand(std::uint32_t word) { return {false, {word}}; }

Operand stringOperand(const std::string& text) {
  Operand operand{false, std::vector<std::uint32_t>(text.size() / 4 + 1, 0)};
  std::memcpy(operand.words.data(), text.data(), text.size());
  return operand;
}

std::string stringOf(const Operand& operand) {
  const char* text = reinterpret_cast<const char*>(operand.words.data());
  return {text, strnlen(text, operand.words.size() * 4)};
}

Instruction makeInstruction(spv::Op opcode, std::uint32_t type_id, std::uint32_t result_id,
                            std::vector<Operand> operands) {
  return {opcode, type_id, result_id, std::move(operands), {}};
}

const Function* findFunction(const Module& module, std::uint32_t id) {
  for (const Function& function : module.functions)
    if (function.id() == id) return &function;
  return nullptr;
}

Function* findFunction(Module& module, std::uint32_t id) {
  return const_cast<Function*>(findFunction(static_cast<const Module&>(module), id));
}

const Instruction* findEntryPoint(const Module& module, const std::string& name) {
  if (name.empty()) return module.entry_points.size() == 1 ? &module.entry_points[0] : nullptr;
  for (const Instruction& entry : module.entry_points)
    if (stringOf(entry.operands[2]) == name) return &entry;
  return nullptr;
}

std::string nameOf(const Module& module, std::uint32_t id) {
  for (const Instruction& name : module.names)
    if (name.opcode == spv::Op::OpName && name.word(0) == id) return stringOf(name.operands[1]);
  return "";
}

std::string memberNameOf(const Module& module, std::uint32_t type_id, std::uint32_t member) {
  for (const Instruction& name : module.names)
    if (name.opcode == spv::Op::OpMemberName && name.word(0) == type_id && name.word(1) == member)
      return stringOf(name.operands[2]);
  return "";
}

const Instruction* findGlobal(const Module& module, std::uint32_t id) {
  for (const Instruction& global : module.globals)
    if (global.result_id == id) return &global;
  return nullptr;
}

std::optional<std::uint32_t> decorationOf(const Module& module, std::uint32_t id, spv::Decoration decoration) {
  for (const Instruction& annotation : module.annotations)
    if (annotation.opcode == spv::Op::OpDecorate && annotation.word(0) == id &&
        annotation.word(1) == static_cast<std::uint32_t>(decoration))
      return annotation.operands.size() > 2 ? annotation.word(2) : 0;
  return std::nullopt;
}

std::optional<std::uint32_t> memberDecorationOf(const Module& module, std::uint32_t type_id, std::uint32_t member,
                                                spv::Decoration decoration) {
  for (const Instruction& annotation : module.annotations)
    if (annotation.opcode == spv::Op::OpMemberDecorate && annotation.word(0) == type_id &&
        annotation.word(1) == member && annotation.word(2) == static_cast<std::uint32_t>(decoration))
      return annotation.operands.size() > 3 ? annotation.word(3) : 0;
  return std::nullopt;
}

}  // namespace reprise

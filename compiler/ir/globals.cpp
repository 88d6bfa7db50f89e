#include "compiler/ir/globals.h"

#include <bit>

namespace reprise {

using spv::Op;

std::uint32_t findOrAddGlobal(Module& module, Op opcode, std::uint32_t type_id, const std::vector<Operand>& operands) {
  for (const Instruction& global : module.globals)
    if (global.opcode == opcode && global.type_id == type_id && global.operands == operands) return global.result_id;
  const std::uint32_t id = module.freshId();
  module.globals.push_back(makeInstruction(opcode, type_id, id, operands));
  return id;
}

std::uint32_t floatType(Module& module) { return findOrAddGlobal(module, Op::OpTypeFloat, 0, {literalOperand(32)}); }
std::uint32_t uintType(Module& module) {
  return findOrAddGlobal(module, Op::OpTypeInt, 0, {literalOperand(32), literalOperand(0)});
}
std::uint32_t intType(Module& module) {
  return findOrAddGlobal(module, Op::OpTypeInt, 0, {literalOperand(32), literalOperand(1)});
}
std::uint32_t vectorType(Module& module, std::uint32_t component_type, std::uint32_t components) {
  return findOrAddGlobal(module, Op::OpTypeVector, 0, {idOperand(component_type), literalOperand(components)});
}
std::uint32_t pointerType(Module& module, spv::StorageClass storage, std::uint32_t pointee) {
  return findOrAddGlobal(module, Op::OpTypePointer, 0,
                         {literalOperand(static_cast<std::uint32_t>(storage)), idOperand(pointee)});
}
std::uint32_t uintConstant(Module& module, std::uint32_t value) {
  return findOrAddGlobal(module, Op::OpConstant, uintType(module), {literalOperand(value)});
}
std::uint32_t intConstant(Module& module, std::int32_t value) {
  return findOrAddGlobal(module, Op::OpConstant, intType(module), {literalOperand(static_cast<std::uint32_t>(value))});
}
std::uint32_t floatConstant(Module& module, float value) {
  return findOrAddGlobal(module, Op::OpConstant, floatType(module), {literalOperand(std::bit_cast<std::uint32_t>(value))});
}

std::uint32_t addVariable(Module& module, spv::StorageClass storage, std::uint32_t pointee, const std::string& name) {
  const std::uint32_t pointer = pointerType(module, storage, pointee);
  const std::uint32_t id = module.freshId();
  module.globals.push_back(
      makeInstruction(Op::OpVariable, pointer, id, {literalOperand(static_cast<std::uint32_t>(storage))}));
  addName(module, id, name);
  return id;
}

void addName(Module& module, std::uint32_t id, const std::string& name) {
  module.names.push_back(makeInstruction(Op::OpName, 0, 0, {idOperand(id), stringOperand(name)}));
}

void addDecoration(Module& module, std::uint32_t id, spv::Decoration decoration, const std::vector<std::uint32_t>& literals) {
  std::vector<Operand> operands{idOperand(id), literalOperand(static_cast<std::uint32_t>(decoration))};
  for (const std::uint32_t literal : literals) operands.push_back(literalOperand(literal));
  module.annotations.push_back(makeInstruction(Op::OpDecorate, 0, 0, std::move(operands)));
}

void removeId(Module& module, std::uint32_t id) {
  const auto targets = [id](const Instruction& instruction) {
    return !instruction.operands.empty() && instruction.operands[0].is_id && instruction.word(0) == id;
  };
  std::erase_if(module.names, targets);
  std::erase_if(module.annotations, targets);
  std::erase_if(module.globals, [id](const Instruction& global) { return global.result_id == id; });
  for (Instruction& entry : module.entry_points)
    for (std::size_t i = entry.operands.size(); i-- > 3;)
      if (entry.word(i) == id) entry.operands.erase(entry.operands.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace reprise

#include "compiler/ir/fold_constants.h"

#include <optional>
#include <unordered_map>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

class Folder {
 public:
  explicit Folder(Module& module) : module_(module) {
    for (const Instruction& global : module.globals)
      if (global.opcode == Op::OpConstant || global.opcode == Op::OpConstantComposite) constants_[global.result_id] = global;
  }

  void fold(Instruction& instruction) {
    for (Operand& operand : instruction.operands)
      if (operand.is_id)
        if (const auto found = folded_.find(operand.words[0]); found != folded_.end()) operand.words[0] = found->second;
    if (const auto constant = valueOf(instruction)) folded_[instruction.result_id] = *constant;
  }

  std::uint32_t resolve(std::uint32_t id) const {
    const auto found = folded_.find(id);
    return found == folded_.end() ? id : found->second;
  }

 private:
  const Instruction* constant(std::uint32_t id) const {
    const auto found = constants_.find(id);
    return found == constants_.end() ? nullptr : &found->second;
  }

  bool isInteger(std::uint32_t type_id) const {
    const Instruction* type = findGlobal(module_, type_id);
    return type != nullptr && type->opcode == Op::OpTypeInt && type->word(0) == 32;
  }

  std::optional<std::uint32_t> valueOf(const Instruction& instruction) {
    switch (instruction.opcode) {
      case Op::OpIAdd:
      case Op::OpISub:
      case Op::OpIMul: return arithmetic(instruction);
      case Op::OpCompositeExtract: return element(instruction);
      default: return std::nullopt;
    }
  }

  // Two's complement: signed and unsigned words alike.
  std::optional<std::uint32_t> arithmetic(const Instruction& instruction) {
    const Instruction *left = constant(instruction.word(0)), *right = constant(instruction.word(1));
    if (left == nullptr || right == nullptr || !isInteger(instruction.type_id)) return std::nullopt;
    const std::uint32_t a = left->word(0), b = right->word(0);
    const std::uint32_t word = instruction.opcode == Op::OpIAdd ? a + b : instruction.opcode == Op::OpISub ? a - b : a * b;
    const std::uint32_t id = findOrAddGlobal(module_, Op::OpConstant, instruction.type_id, {literalOperand(word)});
    constants_[id] = *findGlobal(module_, id);
    return id;
  }

  std::optional<std::uint32_t> element(const Instruction& extract) const {
    std::uint32_t id = extract.word(0);
    for (std::size_t i = 1; i < extract.operands.size(); ++i) {
      const Instruction* composite = constant(id);
      if (composite == nullptr || composite->opcode != Op::OpConstantComposite || extract.word(i) >= composite->operands.size())
        return std::nullopt;
      id = composite->word(extract.word(i));
    }
    return constant(id) != nullptr ? std::optional<std::uint32_t>(id) : std::nullopt;
  }

  Module& module_;
  std::unordered_map<std::uint32_t, Instruction> constants_;
  std::unordered_map<std::uint32_t, std::uint32_t> folded_;
};

}  // namespace

Module foldConstants(const Module& module) {
  Module result = module;
  Folder folder(result);
  // Blocks stand in an order in which definitions come before uses, but for phis of loops.
  for (Function& function : result.functions)
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions) folder.fold(instruction);
  for (Function& function : result.functions)
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions)
        if (instruction.opcode == Op::OpPhi)
          for (Operand& operand : instruction.operands)
            if (operand.is_id) operand.words[0] = folder.resolve(operand.words[0]);
  return result;
}

}  // namespace reprise

#include "compiler/ir/local_access.h"

namespace reprise {
namespace {

using spv::Op;

bool isVolatile(const Instruction& access, std::size_t operand) {
  return access.operands.size() > operand && (access.word(operand) & static_cast<std::uint32_t>(spv::MemoryAccessMask::Volatile)) != 0;
}

}  // namespace

LocalAccess::LocalAccess(const Module& module, const Function& function) {
  std::unordered_map<std::uint32_t, bool> narrow;  // integer types of at most 32 bits
  for (const Instruction& global : module.globals) {
    if (global.opcode == Op::OpTypeInt) narrow[global.result_id] = global.word(0) <= 32;
    if (global.opcode == Op::OpConstant && narrow.count(global.type_id) != 0 && narrow[global.type_id]) constants_[global.result_id] = global.word(0);
    if (global.opcode == Op::OpConstantNull && narrow.count(global.type_id) != 0) constants_[global.result_id] = 0;
  }
  // Blocks stand in an order of dominance, so that a chain comes after what it begins with.
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions) visit(instruction);
}

void LocalAccess::visit(const Instruction& instruction) {
  if (instruction.opcode == Op::OpVariable) {
    pointers_[instruction.result_id] = {instruction.result_id, {}};
    return;
  }
  const bool chain = instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpInBoundsAccessChain;
  if (chain || instruction.opcode == Op::OpCopyObject) {
    const LocalPointer* base = find(instruction.word(0));
    if (base == nullptr) return;
    LocalPointer pointer = *base;
    for (std::size_t i = 1; i < instruction.operands.size(); ++i) pointer.indices.push_back(instruction.word(i));
    pointers_[instruction.result_id] = std::move(pointer);
    return;
  }
  const bool loads = instruction.opcode == Op::OpLoad && !isVolatile(instruction, 1);
  const bool stores = instruction.opcode == Op::OpStore && !isVolatile(instruction, 2);
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    if (!instruction.operands[i].is_id || (i == 0 && (loads || stores))) continue;
    if (const LocalPointer* pointer = find(instruction.word(i))) escaping_[pointer->variable].push_back(*pointer);
  }
}

const LocalPointer* LocalAccess::find(std::uint32_t pointer) const {
  const auto found = pointers_.find(pointer);
  return found == pointers_.end() ? nullptr : &found->second;
}

const std::vector<LocalPointer>& LocalAccess::escaping(std::uint32_t variable) const {
  static const std::vector<LocalPointer> kNone;
  const auto found = escaping_.find(variable);
  return found == escaping_.end() ? kNone : found->second;
}

std::optional<std::uint32_t> LocalAccess::constantIndex(std::uint32_t id) const {
  const auto found = constants_.find(id);
  return found == constants_.end() ? std::nullopt : std::optional<std::uint32_t>(found->second);
}

}  // namespace reprise

#include "compiler/ir/types.h"

namespace reprise {

using spv::Op;

Types::Types(const Module& module) {
  for (const Instruction& global : module.globals)
    if (global.result_id != 0) globals_[global.result_id] = &global;
}

const Instruction* Types::find(std::uint32_t id) const {
  const auto found = globals_.find(id);
  return found == globals_.end() ? nullptr : found->second;
}

std::uint32_t Types::pointee(std::uint32_t pointer_type) const {
  const Instruction* type = find(pointer_type);
  REPRISE_CHECK(type != nullptr && type->opcode == Op::OpTypePointer, pointer_type);
  return type->word(1);
}

std::optional<std::uint32_t> Types::parts(std::uint32_t type_id) const {
  const Instruction* type = find(type_id);
  if (type == nullptr) return std::nullopt;
  if (type->opcode == Op::OpTypeStruct) return static_cast<std::uint32_t>(type->operands.size());
  if (type->opcode != Op::OpTypeArray) return std::nullopt;
  const Instruction* length = find(type->word(1));
  if (length == nullptr || length->opcode != Op::OpConstant) return std::nullopt;
  return length->word(0);
}

std::uint32_t Types::part(std::uint32_t type_id, std::uint32_t index) const {
  const Instruction* type = find(type_id);
  REPRISE_CHECK(type != nullptr, type_id);
  return type->opcode == Op::OpTypeStruct ? type->word(index) : type->word(0);
}

std::uint32_t Types::at(std::uint32_t type_id, std::uint32_t index) const {
  const Instruction* type = find(type_id);
  if (type == nullptr) return 0;
  if (type->opcode == Op::OpTypeVector || type->opcode == Op::OpTypeMatrix) return index < type->word(1) ? type->word(0) : 0;
  const std::optional<std::uint32_t> count = parts(type_id);
  return count && index < *count ? part(type_id, index) : 0;
}

}  // namespace reprise

#include "compiler/ir/builder.h"

namespace reprise {

using spv::Op;

std::uint32_t Builder::result(Op opcode, std::uint32_t type_id, std::vector<Operand> operands, std::uint32_t id) {
  if (id == 0) id = module_.freshId();
  code_.push_back({opcode, type_id, id, std::move(operands), line_});
  return id;
}

void Builder::effect(Op opcode, std::vector<Operand> operands) { code_.push_back({opcode, 0, 0, std::move(operands), line_}); }

std::uint32_t Builder::load(std::uint32_t type_id, std::uint32_t pointer, std::uint32_t id) {
  return result(Op::OpLoad, type_id, {idOperand(pointer)}, id);
}

void Builder::store(std::uint32_t pointer, std::uint32_t value) { effect(Op::OpStore, {idOperand(pointer), idOperand(value)}); }

std::uint32_t Builder::extract(std::uint32_t type_id, std::uint32_t composite, std::span<const std::uint32_t> indices, std::uint32_t id) {
  if (indices.empty()) return id == 0 ? composite : result(Op::OpCopyObject, type_id, {idOperand(composite)}, id);
  std::vector<Operand> operands{idOperand(composite)};
  for (const std::uint32_t index : indices) operands.push_back(literalOperand(index));
  return result(Op::OpCompositeExtract, type_id, std::move(operands), id);
}

std::uint32_t Builder::insert(std::uint32_t type_id, std::uint32_t part, std::uint32_t composite, std::span<const std::uint32_t> indices) {
  if (indices.empty()) return part;
  std::vector<Operand> operands{idOperand(part), idOperand(composite)};
  for (const std::uint32_t index : indices) operands.push_back(literalOperand(index));
  return result(Op::OpCompositeInsert, type_id, std::move(operands));
}

std::uint32_t Builder::construct(std::uint32_t type_id, std::span<const std::uint32_t> parts, std::uint32_t id) {
  std::vector<Operand> operands;
  for (const std::uint32_t part : parts) operands.push_back(idOperand(part));
  return result(Op::OpCompositeConstruct, type_id, std::move(operands), id);
}

void Builder::branch(std::uint32_t label) { effect(Op::OpBranch, {idOperand(label)}); }

void Builder::branchIf(std::uint32_t condition, std::uint32_t if_true, std::uint32_t if_false) {
  effect(Op::OpBranchConditional, {idOperand(condition), idOperand(if_true), idOperand(if_false)});
}

void Builder::mergeAt(std::uint32_t label) { effect(Op::OpSelectionMerge, {idOperand(label), literalOperand(0)}); }

}  // namespace reprise

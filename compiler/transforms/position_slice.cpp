#include "compiler/transforms/position_slice.h"

#include <algorithm>

#include "compiler/ir/globals.h"
#include "compiler/ir/optimize.h"
#include "compiler/transforms/clone_function.h"
#include "compiler/transforms/redirect_variable.h"
#include "compiler/transforms/type_size.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

struct PositionOutput {
  std::uint32_t variable = 0;
  std::optional<std::uint32_t> member;  // of a gl_PerVertex block
};

std::uint32_t pointeeOf(const Module& module, const Instruction& variable) { return findGlobal(module, variable.type_id)->word(1); }

std::optional<PositionOutput> findPosition(const Module& module) {
  const auto position = static_cast<std::uint32_t>(spv::BuiltIn::Position);
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || static_cast<StorageClass>(global.word(0)) != StorageClass::Output) continue;
    if (decorationOf(module, global.result_id, spv::Decoration::BuiltIn) == position) return PositionOutput{global.result_id, {}};
    const std::uint32_t type_id = pointeeOf(module, global);
    const Instruction* type = findGlobal(module, type_id);
    if (type->opcode != Op::OpTypeStruct) continue;
    for (std::uint32_t member = 0; member < type->operands.size(); ++member)
      if (memberDecorationOf(module, type_id, member, spv::Decoration::BuiltIn) == position)
        return PositionOutput{global.result_id, member};
  }
  return std::nullopt;
}

// Of the shader's own: not what comes with the vertex, nor what the shader itself keeps.
bool comesFromOutside(StorageClass storage) {
  return storage != StorageClass::Input && storage != StorageClass::Output && storage != StorageClass::Private;
}

PositionSource sourceOf(const Module& module, StorageClass storage, std::uint32_t pointee) {
  if (storage == StorageClass::PushConstant) return PositionSource::kPushConstants;
  const bool block = storage == StorageClass::Uniform && decorationOf(module, pointee, spv::Decoration::Block);
  return block ? PositionSource::kUniformBlock : PositionSource::kOther;
}

// As far as constants step from struct to struct; of arrays, vectors and matrices the whole.
ByteRange rangeOf(const Module& module, std::uint32_t block, const Instruction& chain) {
  ByteRange range{0, sizeOf(module, block)};
  std::uint32_t type_id = block;
  for (std::size_t at = 1; at < chain.operands.size(); ++at) {
    const Instruction* type = findGlobal(module, type_id);
    if (type->opcode != Op::OpTypeStruct) break;
    const std::uint32_t member = findGlobal(module, chain.word(at))->word(0);
    range.offset += memberDecorationOf(module, type_id, member, spv::Decoration::Offset).value_or(0);
    range.size = memberSize(module, type_id, member);
    type_id = type->word(member);
  }
  return range;
}

bool names(const Instruction& instruction, std::uint32_t id) {
  return std::any_of(instruction.operands.begin(), instruction.operands.end(),
                     [&](const Operand& operand) { return operand.is_id && operand.words[0] == id; });
}

std::vector<ByteRange> rangesRead(const Module& module, const Function& function, std::uint32_t variable, std::uint32_t block) {
  std::vector<ByteRange> ranges;
  for (const Block& code : function.blocks)
    for (const Instruction& instruction : code.instructions) {
      if (!names(instruction, variable)) continue;
      const bool chain = instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpInBoundsAccessChain;
      ranges.push_back(chain ? rangeOf(module, block, instruction) : ByteRange{0, sizeOf(module, block)});
    }
  std::sort(ranges.begin(), ranges.end(), [](const ByteRange& a, const ByteRange& b) { return std::pair(a.offset, a.size) < std::pair(b.offset, b.size); });
  ranges.erase(std::unique(ranges.begin(), ranges.end()), ranges.end());
  return ranges;
}

}  // namespace

std::unordered_set<std::uint32_t> idsUsedBy(const Function& function) {
  std::unordered_set<std::uint32_t> used;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      for (const Operand& operand : instruction.operands)
        if (operand.is_id) used.insert(operand.words[0]);
  return used;
}

Result<PositionSlice> slicePosition(const Module& vertex) {
  REPRISE_CHECK(vertex.entry_points.size() == 1, vertex.entry_points.size());
  const auto position = findPosition(vertex);
  if (!position) return Error{ErrorKind::kRefused, "vertex.no_position", "the vertex shader writes no gl_Position", {}};
  const std::uint32_t current = vertex.entry_points.front().word(1);
  ClonedFunction cloned = cloneFunction(vertex, current);
  PositionSlice slice;
  slice.function = cloned.function;
  slice.output = position->variable;
  Module& module = slice.module;
  module = addEntryPoint(cloned.module, cloned.function, "reprise_prior", current);
  const std::uint32_t vec4 = vectorType(module, floatType(module), 4);
  // An output while dead code is removed, so that its stores count; linking makes it the frame's private variable.
  slice.slot = addVariable(module, StorageClass::Output, vec4, "reprise_position_slot");
  for (Instruction& entry : module.entry_points) entry.operands.push_back(idOperand(slice.slot));
  REPRISE_ASSIGN(module, redirectVariable(module, {cloned.function, position->variable, slice.slot, {}, position->member}));
  REPRISE_ASSIGN(module, hideOutputs(module, cloned.function, HiddenOutputs::kColors));
  REPRISE_ASSIGN(module, removeDeadCode(module));
  return slice;
}

Result<std::vector<PositionInput>> positionInputs(const Module& vertex) {
  REPRISE_ASSIGN(const PositionSlice slice, slicePosition(vertex));
  const Module& module = slice.module;
  const Function& function = *findFunction(module, slice.function);
  const std::unordered_set<std::uint32_t> used = idsUsedBy(function);
  std::vector<PositionInput> inputs;
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || used.count(global.result_id) == 0) continue;
    const auto storage = static_cast<StorageClass>(global.word(0));
    if (!comesFromOutside(storage)) continue;
    const std::uint32_t block = pointeeOf(module, global);
    PositionInput input;
    input.source = sourceOf(module, storage, block);
    input.set = decorationOf(module, global.result_id, spv::Decoration::DescriptorSet).value_or(0);
    input.binding = decorationOf(module, global.result_id, spv::Decoration::Binding).value_or(0);
    const bool is_block = input.source != PositionSource::kOther;
    input.name = nameOf(module, is_block ? block : global.result_id);
    if (is_block) input.read = rangesRead(module, function, global.result_id, block);
    inputs.push_back(std::move(input));
  }
  return inputs;
}

}  // namespace reprise

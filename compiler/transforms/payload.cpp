#include "compiler/transforms/payload.h"

#include <algorithm>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

struct Position {
  Block* block = nullptr;
  std::size_t index = 0;  // of the instruction
};

Position find(Module& module, const PayloadPlace& place) {
  Function* function = findFunction(module, place.function);
  REPRISE_CHECK(function != nullptr, place.function);
  for (Block& block : function->blocks)
    for (std::size_t i = 0; i < block.instructions.size(); ++i)
      if (block.instructions[i].result_id == place.value) return {&block, i};
  REPRISE_CHECK(false, place.value);
  return {};
}

// Where code that follows the value may stand: phis come first in a block.
std::size_t afterPhis(const Block& block, std::size_t index) {
  while (index < block.instructions.size() && block.instructions[index].opcode == Op::OpPhi) ++index;
  return index;
}

std::uint32_t channelsOf(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  return type->opcode == Op::OpTypeVector ? type->word(1) : 1;
}

void insert(Block& block, std::size_t index, const std::vector<Instruction>& instructions) {
  block.instructions.insert(block.instructions.begin() + static_cast<std::ptrdiff_t>(index), instructions.begin(),
                            instructions.end());
}

}  // namespace

Module substitutePayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  const std::uint32_t vec4 = vectorType(result, floatType(result), 4);
  const std::uint32_t loaded = result.freshId();
  const Position position = find(result, place);
  const Instruction computed = position.block->instructions[position.index];
  const std::uint32_t channels = channelsOf(result, computed.type_id);
  Instruction taken = makeInstruction(Op::OpCopyObject, computed.type_id, place.value, {idOperand(loaded)});
  if (channels == 1) {
    taken = makeInstruction(Op::OpCompositeExtract, computed.type_id, place.value, {idOperand(loaded), literalOperand(0)});
  } else if (channels < 4) {
    taken = makeInstruction(Op::OpVectorShuffle, computed.type_id, place.value, {idOperand(loaded), idOperand(loaded)});
    for (std::uint32_t channel = 0; channel < channels; ++channel) taken.operands.push_back(literalOperand(channel));
  }
  taken.line = computed.line;
  Instruction load = makeInstruction(Op::OpLoad, vec4, loaded, {idOperand(place.payload_variable)});
  load.line = computed.line;
  Block& block = *position.block;
  const std::size_t after = afterPhis(block, position.index);
  // The computation keeps its place under a new id, without decorations; dead-code elimination removes it.
  block.instructions[position.index].result_id = result.freshId();
  insert(block, std::max(after, position.index + 1), {load, taken});
  std::erase_if(result.annotations, [&](const Instruction& annotation) {
    return annotation.opcode == Op::OpDecorate && annotation.word(0) == place.value;
  });
  return result;
}

Module exportPayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  const std::uint32_t vec4 = vectorType(result, floatType(result), 4);
  const std::uint32_t zero = floatConstant(result, 0);
  const std::uint32_t yes = uintConstant(result, 1);
  std::uint32_t whole = result.freshId();
  const Position position = find(result, place);
  const Instruction& computed = position.block->instructions[position.index];
  const LineMark line = computed.line;
  const std::uint32_t channels = channelsOf(result, computed.type_id);
  std::vector<Instruction> added;
  if (channels == 4) {
    whole = place.value;
  } else {
    added.push_back(makeInstruction(Op::OpCompositeConstruct, vec4, whole, {idOperand(place.value)}));
    for (std::uint32_t channel = channels; channel < 4; ++channel) added.back().operands.push_back(idOperand(zero));
  }
  added.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(place.payload_variable), idOperand(whole)}));
  added.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(place.valid_variable), idOperand(yes)}));
  for (Instruction& instruction : added) instruction.line = line;
  insert(*position.block, std::max(afterPhis(*position.block, position.index), position.index + 1), added);
  return result;
}

}  // namespace reprise

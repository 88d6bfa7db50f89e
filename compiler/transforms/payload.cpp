#include "compiler/transforms/payload.h"

#include <algorithm>

#include "compiler/ir/globals.h"
#include "compiler/ir/payload_type.h"

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

// How the payload variable holds values of a type. The ids are of types.
struct Carrier {
  PayloadType type;
  std::uint32_t component = 0;  // float or uint
  std::uint32_t vector = 0;     // of the variable: four components
  std::uint32_t value = 0;      // as many components as the value has; its own type if that is float or uint
};

Carrier carrierOf(Module& module, std::uint32_t type_id) {
  Carrier carrier{payloadType(module, type_id)};
  REPRISE_CHECK(carrier.type.channels > 0, type_id);
  carrier.component = isInteger(carrier.type.scalar) ? uintType(module) : floatType(module);
  carrier.vector = vectorType(module, carrier.component, 4);
  const auto channels = static_cast<std::uint32_t>(carrier.type.channels);
  carrier.value = channels == 1 ? carrier.component : vectorType(module, carrier.component, channels);
  return carrier;
}

std::uint32_t zeroOf(Module& module, std::uint32_t type_id) {
  return findOrAddGlobal(module, Op::OpConstantNull, type_id, {});
}

std::uint32_t oneOf(Module& module, const Carrier& carrier) {
  const std::uint32_t one = uintConstant(module, 1);
  if (carrier.type.channels == 1) return one;
  const std::vector<Operand> ones(static_cast<std::size_t>(carrier.type.channels), idOperand(one));
  return findOrAddGlobal(module, Op::OpConstantComposite, carrier.value, ones);
}

struct Conversion {
  std::uint32_t from = 0, to = 0;  // values
  std::uint32_t type_id = 0;       // of the user's value
};

// Back from the carrier's type to the user's.
Instruction unpack(Module& module, const Carrier& carrier, const Conversion& ids) {
  const Op opcode = carrier.type.scalar == PayloadScalar::kInt    ? Op::OpBitcast
                    : carrier.type.scalar == PayloadScalar::kHalf ? Op::OpFConvert
                                                                  : Op::OpINotEqual;
  Instruction converted = makeInstruction(opcode, ids.type_id, ids.to, {idOperand(ids.from)});
  if (opcode == Op::OpINotEqual) converted.operands.push_back(idOperand(zeroOf(module, carrier.value)));
  return converted;
}

Instruction pack(Module& module, const Carrier& carrier, const Conversion& ids) {
  if (carrier.type.scalar == PayloadScalar::kBool) {
    const std::uint32_t one = oneOf(module, carrier), zero = zeroOf(module, carrier.value);
    return makeInstruction(Op::OpSelect, carrier.value, ids.to, {idOperand(ids.from), idOperand(one), idOperand(zero)});
  }
  const Op opcode = carrier.type.scalar == PayloadScalar::kHalf ? Op::OpFConvert : Op::OpBitcast;
  return makeInstruction(opcode, carrier.value, ids.to, {idOperand(ids.from)});
}

// The first channels of the loaded vector.
Instruction takeChannels(const Carrier& carrier, std::uint32_t loaded, std::uint32_t taken) {
  const auto channels = static_cast<std::uint32_t>(carrier.type.channels);
  const Operand from = idOperand(loaded);
  if (channels == 4) return makeInstruction(Op::OpCopyObject, carrier.value, taken, {from});
  if (channels == 1) return makeInstruction(Op::OpCompositeExtract, carrier.value, taken, {from, literalOperand(0)});
  Instruction shuffle = makeInstruction(Op::OpVectorShuffle, carrier.value, taken, {from, from});
  for (std::uint32_t channel = 0; channel < channels; ++channel) shuffle.operands.push_back(literalOperand(channel));
  return shuffle;
}

void insert(Block& block, std::size_t index, const std::vector<Instruction>& instructions) {
  block.instructions.insert(block.instructions.begin() + static_cast<std::ptrdiff_t>(index), instructions.begin(),
                            instructions.end());
}

}  // namespace

std::uint32_t payloadVectorType(Module& module, std::uint32_t value_type) {
  return carrierOf(module, value_type).vector;
}

Module substitutePayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  const Position position = find(result, place);
  const Instruction computed = position.block->instructions[position.index];
  const Carrier carrier = carrierOf(result, computed.type_id);
  const std::uint32_t loaded = result.freshId();
  const bool converts = carrier.value != computed.type_id;
  const std::uint32_t taken = converts ? result.freshId() : place.value;
  std::vector<Instruction> added;
  added.push_back(makeInstruction(Op::OpLoad, carrier.vector, loaded, {idOperand(place.payload_variable)}));
  added.push_back(takeChannels(carrier, loaded, taken));
  if (converts) added.push_back(unpack(result, carrier, {taken, place.value, computed.type_id}));
  for (Instruction& instruction : added) instruction.line = computed.line;
  Block& block = *position.block;
  const std::size_t after = afterPhis(block, position.index);
  // The computation keeps its place under a new id, without decorations; dead-code elimination removes it.
  block.instructions[position.index].result_id = result.freshId();
  insert(block, std::max(after, position.index + 1), added);
  std::erase_if(result.annotations, [&](const Instruction& annotation) {
    return annotation.opcode == Op::OpDecorate && annotation.word(0) == place.value;
  });
  return result;
}

Module exportPayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  const Position position = find(result, place);
  const Instruction computed = position.block->instructions[position.index];
  const Carrier carrier = carrierOf(result, computed.type_id);
  const std::uint32_t zero = zeroOf(result, carrier.component), yes = uintConstant(result, 1);
  std::vector<Instruction> added;
  std::uint32_t packed = place.value;
  if (carrier.value != computed.type_id) {
    packed = result.freshId();
    added.push_back(pack(result, carrier, {place.value, packed, computed.type_id}));
  }
  std::uint32_t whole = packed;
  if (carrier.type.channels < 4) {
    whole = result.freshId();
    added.push_back(makeInstruction(Op::OpCompositeConstruct, carrier.vector, whole, {idOperand(packed)}));
    for (int channel = carrier.type.channels; channel < 4; ++channel) added.back().operands.push_back(idOperand(zero));
  }
  added.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(place.payload_variable), idOperand(whole)}));
  added.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(place.valid_variable), idOperand(yes)}));
  for (Instruction& instruction : added) instruction.line = computed.line;
  insert(*position.block, std::max(afterPhis(*position.block, position.index), position.index + 1), added);
  return result;
}

}  // namespace reprise

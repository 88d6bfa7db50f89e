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

Position find(Module& module, std::uint32_t function_id, std::uint32_t value) {
  Function* function = findFunction(module, function_id);
  REPRISE_CHECK(function != nullptr, function_id);
  for (Block& block : function->blocks)
    for (std::size_t i = 0; i < block.instructions.size(); ++i)
      if (block.instructions[i].result_id == value) return {&block, i};
  REPRISE_CHECK(false, value);
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
  std::uint32_t value = 0;      // as many components as the value has; its own type if that is float or uint
};

Carrier carrierOf(Module& module, std::uint32_t type_id) {
  Carrier carrier{payloadType(module, type_id)};
  REPRISE_CHECK(carrier.type.channels > 0, type_id);
  carrier.component = isInteger(carrier.type.scalar) ? uintType(module) : floatType(module);
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

// Pointer, in the payload variable, to a channel.
class Channels {
 public:
  Channels(Module& module, std::uint32_t variable, std::uint32_t component)
      : module_(module), variable_(variable), component_(component),
        storage_(static_cast<spv::StorageClass>(findGlobal(module, variable)->word(0))) {}

  std::uint32_t pointerTo(int channel, std::vector<Instruction>& code) {
    const auto flat = static_cast<std::uint32_t>(channel);
    const std::uint32_t pointer = module_.freshId();
    const std::uint32_t target = uintConstant(module_, flat / 4), component = uintConstant(module_, flat % 4);
    code.push_back(makeInstruction(Op::OpAccessChain, pointerType(module_, storage_, component_), pointer,
                                   {idOperand(variable_), idOperand(target), idOperand(component)}));
    return pointer;
  }

  std::uint32_t load(int channel, std::vector<Instruction>& code) {
    const std::uint32_t pointer = pointerTo(channel, code), loaded = module_.freshId();
    code.push_back(makeInstruction(Op::OpLoad, component_, loaded, {idOperand(pointer)}));
    return loaded;
  }

  void store(int channel, std::uint32_t value, std::vector<Instruction>& code) {
    const std::uint32_t pointer = pointerTo(channel, code);
    code.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(pointer), idOperand(value)}));
  }

 private:
  Module& module_;
  std::uint32_t variable_, component_;
  spv::StorageClass storage_;
};

// Puts code after the instruction at `position`, behind the phis that may follow it, with its line.
void insertAfter(const Position& position, std::vector<Instruction> code) {
  Block& block = *position.block;
  const LineMark line = block.instructions[position.index].line;
  for (Instruction& instruction : code) instruction.line = line;
  const std::size_t at = std::max(afterPhis(block, position.index), position.index + 1);
  block.instructions.insert(block.instructions.begin() + static_cast<std::ptrdiff_t>(at), code.begin(), code.end());
}

void substitute(Module& module, const PayloadPlace& place, const PayloadPart& part) {
  const Position position = find(module, place.function, part.value);
  const Instruction computed = position.block->instructions[position.index];
  const Carrier carrier = carrierOf(module, computed.type_id);
  const bool converts = carrier.value != computed.type_id;
  const std::uint32_t taken = converts ? module.freshId() : part.value;
  Channels channels(module, place.payload_variable, carrier.component);
  std::vector<Instruction> code;
  std::vector<Operand> components;
  for (int channel = 0; channel < carrier.type.channels; ++channel)
    components.push_back(idOperand(channels.load(part.first_channel + channel, code)));
  if (components.size() == 1) {
    code.back().result_id = taken;
  } else {
    code.push_back(makeInstruction(Op::OpCompositeConstruct, carrier.value, taken, components));
  }
  if (converts) code.push_back(unpack(module, carrier, {taken, part.value, computed.type_id}));
  // The computation keeps its place under a new id, without decorations; dead-code elimination removes it.
  position.block->instructions[position.index].result_id = module.freshId();
  insertAfter(position, std::move(code));
  std::erase_if(module.annotations, [&](const Instruction& annotation) {
    return annotation.opcode == Op::OpDecorate && annotation.word(0) == part.value;
  });
}

void exportValue(Module& module, const PayloadPlace& place, const PayloadPart& part) {
  const Position position = find(module, place.function, part.value);
  const Instruction computed = position.block->instructions[position.index];
  const Carrier carrier = carrierOf(module, computed.type_id);
  Channels channels(module, place.payload_variable, carrier.component);
  std::vector<Instruction> code;
  std::uint32_t packed = part.value;
  if (carrier.value != computed.type_id) {
    packed = module.freshId();
    code.push_back(pack(module, carrier, {part.value, packed, computed.type_id}));
  }
  for (int channel = 0; channel < carrier.type.channels; ++channel) {
    std::uint32_t component = packed;
    if (carrier.type.channels > 1) {
      component = module.freshId();
      code.push_back(makeInstruction(Op::OpCompositeExtract, carrier.component, component,
                                     {idOperand(packed), literalOperand(static_cast<std::uint32_t>(channel))}));
    }
    channels.store(part.first_channel + channel, component, code);
  }
  if (part.guard_channel != kNoGuard) {
    const std::uint32_t one = isInteger(carrier.type.scalar) ? uintConstant(module, 1) : floatConstant(module, 1);
    channels.store(part.guard_channel, one, code);
  }
  insertAfter(position, std::move(code));
}

// Discarding belongs to the bodies that shade: this one only tells.
void endNoInvocation(Function& function) {
  for (Block& block : function.blocks) {
    std::erase_if(block.instructions, [](const Instruction& one) { return one.opcode == Op::OpDemoteToHelperInvocation; });
    Instruction& last = block.instructions.back();
    if (last.opcode == Op::OpKill || last.opcode == Op::OpTerminateInvocation) last = makeInstruction(Op::OpReturn, 0, 0, {});
  }
}

}  // namespace

std::uint32_t payloadArrayType(Module& module, std::uint32_t value_type, std::uint32_t targets) {
  const std::uint32_t vector = vectorType(module, carrierOf(module, value_type).component, 4);
  // A type of its own: an equal one of the shader's may be decorated with a stride, which interface variables must not have.
  const std::uint32_t length = uintConstant(module, targets), id = module.freshId();
  module.globals.push_back(makeInstruction(Op::OpTypeArray, 0, id, {idOperand(vector), idOperand(length)}));
  return id;
}

Module substitutePayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  for (const PayloadPart& part : place.parts) substitute(result, place, part);
  return result;
}

Module exportPayload(const Module& module, const PayloadPlace& place) {
  Module result = module;
  for (const PayloadPart& part : place.parts) exportValue(result, place, part);
  return result;
}

Module exportWanted(const Module& module, const PayloadPlace& place, std::uint32_t wanted_variable) {
  Module result = module;
  const std::uint32_t type = uintType(result);
  for (const PayloadPart& part : place.parts) {
    if (part.guard_channel == kNoGuard) continue;
    REPRISE_CHECK(part.guard_channel < 32, part.guard_channel);
    const std::uint32_t before = result.freshId(), after = result.freshId();
    const std::uint32_t bit = uintConstant(result, 1u << part.guard_channel);
    insertAfter(find(result, place.function, part.value),
                {makeInstruction(Op::OpLoad, type, before, {idOperand(wanted_variable)}),
                 makeInstruction(Op::OpBitwiseOr, type, after, {idOperand(before), idOperand(bit)}),
                 makeInstruction(Op::OpStore, 0, 0, {idOperand(wanted_variable), idOperand(after)})});
  }
  endNoInvocation(*findFunction(result, place.function));
  return result;
}

}  // namespace reprise

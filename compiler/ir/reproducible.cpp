#include "compiler/ir/reproducible.h"

#include <algorithm>
#include <map>
#include <unordered_set>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

constexpr std::uint32_t kUndefinedComponent = 0xffffffffu;

bool hasZero(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  if (type == nullptr) return false;
  switch (type->opcode) {
    case Op::OpTypeBool:
    case Op::OpTypeInt:
    case Op::OpTypeFloat: return true;
    case Op::OpTypeVector:
    case Op::OpTypeMatrix: return hasZero(module, type->word(0));
    // SPIRV-Cross cannot read a zero of an array whose length is a specialization constant.
    case Op::OpTypeArray: {
      const Instruction* length = findGlobal(module, type->word(1));
      return length != nullptr && length->opcode == Op::OpConstant && hasZero(module, type->word(0));
    }
    case Op::OpTypeStruct:
      return std::all_of(type->operands.begin(), type->operands.end(), [&](const Operand& member) { return hasZero(module, member.words[0]); });
    default: return false;
  }
}

// OpConstantNull by type, each right behind its type, where every user may refer to it.
class Zeros {
 public:
  explicit Zeros(Module& module) : module_(module) {}

  std::uint32_t of(std::uint32_t type_id) {
    const auto known = zeros_.find(type_id);
    if (known != zeros_.end()) return known->second;
    const auto type = std::find_if(module_.globals.begin(), module_.globals.end(), [&](const Instruction& global) { return global.result_id == type_id; });
    const std::uint32_t zero = module_.freshId();
    module_.globals.insert(type + 1, makeInstruction(Op::OpConstantNull, type_id, zero, {}));
    return zeros_[type_id] = zero;
  }

 private:
  Module& module_;
  std::map<std::uint32_t, std::uint32_t> zeros_;
};

std::uint32_t pointee(const Module& module, const Instruction& variable) { return findGlobal(module, variable.type_id)->word(1); }

bool lacksInitializer(const Module& module, const Instruction& variable, StorageClass storage) {
  return variable.opcode == Op::OpVariable && static_cast<StorageClass>(variable.word(0)) == storage && variable.operands.size() == 1 &&
         hasZero(module, pointee(module, variable));
}

void replaceUndefined(Module& module, Zeros& zeros) {
  for (std::size_t i = 0; i < module.globals.size(); ++i)
    if (module.globals[i].opcode == Op::OpUndef && hasZero(module, module.globals[i].type_id)) module.globals[i].opcode = Op::OpConstantNull;
  // In functions the instruction becomes a copy of the zero, so that its id stays.
  for (Function& function : module.functions)
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions) {
        if (instruction.opcode == Op::OpVectorShuffle) {
          for (std::size_t i = 2; i < instruction.operands.size(); ++i)
            if (instruction.word(i) == kUndefinedComponent) instruction.operands[i] = literalOperand(0);
        }
        if (instruction.opcode != Op::OpUndef || !hasZero(module, instruction.type_id)) continue;
        instruction.opcode = Op::OpCopyObject;
        instruction.operands = {idOperand(zeros.of(instruction.type_id))};
      }
}

void initializeVariables(Module& module, Zeros& zeros) {
  std::vector<std::uint32_t> privates;
  for (const Instruction& global : module.globals)
    if (lacksInitializer(module, global, StorageClass::Private)) privates.push_back(global.result_id);
  for (const std::uint32_t id : privates) {
    const std::uint32_t zero = zeros.of(pointee(module, *findGlobal(module, id)));
    const auto variable = std::find_if(module.globals.begin(), module.globals.end(), [&](const Instruction& global) { return global.result_id == id; });
    variable->operands.push_back(idOperand(zero));
  }
  for (Function& function : module.functions)
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions)
        if (lacksInitializer(module, instruction, StorageClass::Function))
          instruction.operands.push_back(idOperand(zeros.of(pointee(module, instruction))));
}

// Stores at the start of every entry point; an initializer would not survive that outputs become variables of a pass.
void storeOutputs(Module& module, Zeros& zeros) {
  for (const Instruction& entry : module.entry_points) {
    std::vector<Instruction> stores;
    for (std::size_t i = 3; i < entry.operands.size(); ++i) {
      const Instruction* variable = findGlobal(module, entry.word(i));
      if (variable == nullptr || !lacksInitializer(module, *variable, StorageClass::Output)) continue;
      if (decorationOf(module, variable->result_id, spv::Decoration::BuiltIn)) continue;
      const std::uint32_t id = variable->result_id, type = pointee(module, *variable);
      stores.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(id), idOperand(zeros.of(type))}));
    }
    Function* function = findFunction(module, entry.word(1));
    if (function == nullptr || function->blocks.empty()) continue;
    std::vector<Instruction>& first = function->blocks.front().instructions;
    const auto place = std::find_if(first.begin(), first.end(), [](const Instruction& instruction) { return instruction.opcode != Op::OpVariable; });
    first.insert(place, stores.begin(), stores.end());
  }
}

bool isFloatArithmetic(Op opcode) {
  switch (opcode) {
    case Op::OpFNegate:
    case Op::OpFAdd:
    case Op::OpFSub:
    case Op::OpFMul:
    case Op::OpFDiv:
    case Op::OpFRem:
    case Op::OpFMod:
    case Op::OpVectorTimesScalar:
    case Op::OpMatrixTimesScalar:
    case Op::OpVectorTimesMatrix:
    case Op::OpMatrixTimesVector:
    case Op::OpMatrixTimesMatrix:
    case Op::OpOuterProduct:
    case Op::OpDot: return true;
    default: return false;
  }
}

}  // namespace

Module withDefinedValues(const Module& module) {
  Module result = module;
  Zeros zeros(result);
  replaceUndefined(result, zeros);
  initializeVariables(result, zeros);
  storeOutputs(result, zeros);
  return result;
}

Module withoutContraction(const Module& module) {
  Module result = module;
  std::unordered_set<std::uint32_t> decorated;
  for (const Instruction& annotation : module.annotations)
    if (annotation.opcode == Op::OpDecorate && static_cast<spv::Decoration>(annotation.word(1)) == spv::Decoration::NoContraction)
      decorated.insert(annotation.word(0));
  std::uint32_t functions_set = 0;
  for (const Instruction& import : module.imports)
    if (stringOf(import.operands[0]) == "GLSL.std.450") functions_set = import.result_id;
  const auto computes = [&](const Instruction& instruction) {
    return isFloatArithmetic(instruction.opcode) || (instruction.opcode == Op::OpExtInst && instruction.word(0) == functions_set);
  };
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (computes(instruction) && decorated.insert(instruction.result_id).second)
          addDecoration(result, instruction.result_id, spv::Decoration::NoContraction);
  return result;
}

}  // namespace reprise

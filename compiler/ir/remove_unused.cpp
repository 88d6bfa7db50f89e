#include "compiler/ir/remove_unused.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <unordered_map>
#include <unordered_set>

#include "compiler/ir/live_names.h"

namespace reprise {
namespace {

using spv::Op;

bool isAccess(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain || opcode == Op::OpCopyObject; }

class Marker {
 public:
  Marker(const Module& module, const Function& function) : function_(function) {
    definition_.assign(module.bound, nullptr);
    needed_.assign(module.bound, false);
    for (const Instruction& import : module.imports)
      if (stringOf(import.operands[0]) == "GLSL.std.450") glsl_ = import.result_id;
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions) {
        definition_[instruction.result_id] = &instruction;
        if (instruction.opcode == Op::OpVariable) locals_.insert(instruction.result_id);
      }
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (const std::uint32_t local = storedLocal(instruction); local != 0) stores_[local].push_back(&instruction);
  }

  std::unordered_set<const Instruction*> run() {
    for (const Block& block : function_.blocks)
      for (const Instruction& instruction : block.instructions)
        if (isRoot(instruction)) need(instruction);
    while (!work_.empty()) {
      const Instruction& instruction = *work_.back();
      work_.pop_back();
      for (const Operand& operand : instruction.operands)
        if (operand.is_id) needValue(operand.words[0]);
      // What reads a local, or gets its address, sees all stores to it.
      if (instruction.opcode == Op::OpVariable)
        for (const Instruction* store : stores_[instruction.result_id]) need(*store);
    }
    return std::move(kept_);
  }

 private:
  std::uint32_t localBehind(std::uint32_t pointer) const {
    while (definition_[pointer] != nullptr && isAccess(definition_[pointer]->opcode)) pointer = definition_[pointer]->word(0);
    return locals_.count(pointer) != 0 ? pointer : 0;
  }

  std::uint32_t storedLocal(const Instruction& instruction) const {
    return instruction.opcode == Op::OpStore ? localBehind(instruction.word(0)) : 0;
  }

  // Whether it is needed whoever uses its result.
  bool isRoot(const Instruction& instruction) const {
    if (instruction.opcode == Op::OpStore) return storedLocal(instruction) == 0 || isVolatile(instruction, 2);
    if (instruction.result_id == 0) return true;
    switch (instruction.opcode) {
      case Op::OpFunctionCall: return true;
      case Op::OpLoad: return isVolatile(instruction, 1);
      case Op::OpExtInst: return writesThroughPointer(instruction);
      default: return instruction.opcode >= Op::OpAtomicLoad && instruction.opcode <= Op::OpAtomicXor ? true : isOtherAtomic(instruction.opcode);
    }
  }

  static bool isVolatile(const Instruction& access, std::size_t operand) {
    return access.operands.size() > operand && (access.word(operand) & static_cast<std::uint32_t>(spv::MemoryAccessMask::Volatile)) != 0;
  }

  bool writesThroughPointer(const Instruction& instruction) const {
    if (instruction.word(0) != glsl_) return true;  // of sets that are not known here
    return instruction.word(1) == GLSLstd450Modf || instruction.word(1) == GLSLstd450Frexp;
  }

  static bool isOtherAtomic(Op opcode) {
    switch (opcode) {
      case Op::OpAtomicFlagTestAndSet:
      case Op::OpAtomicFAddEXT:
      case Op::OpAtomicFMinEXT:
      case Op::OpAtomicFMaxEXT:
      case Op::OpRayQueryProceedKHR: return true;
      default: return false;
    }
  }

  void need(const Instruction& instruction) {
    if (!kept_.insert(&instruction).second) return;
    if (instruction.result_id != 0) needed_[instruction.result_id] = true;
    work_.push_back(&instruction);
  }

  void needValue(std::uint32_t id) {
    if (!needed_[id] && definition_[id] != nullptr) need(*definition_[id]);
  }

  const Function& function_;
  std::uint32_t glsl_ = 0;
  std::vector<const Instruction*> definition_;          // by id; of this function
  std::unordered_map<std::uint32_t, std::vector<const Instruction*>> stores_;  // by local variable
  std::vector<bool> needed_;                            // by id
  std::unordered_set<std::uint32_t> locals_;
  std::unordered_set<const Instruction*> kept_;
  std::vector<const Instruction*> work_;
};

}  // namespace

Module removeUnused(const Module& module) {
  Module result = module;
  for (std::size_t i = 0; i < module.functions.size(); ++i) {
    const std::unordered_set<const Instruction*> kept = Marker(module, module.functions[i]).run();
    for (std::size_t block = 0; block < module.functions[i].blocks.size(); ++block) {
      const std::vector<Instruction>& all = module.functions[i].blocks[block].instructions;
      std::vector<Instruction> needed;
      for (const Instruction& instruction : all)
        if (kept.count(&instruction) != 0) needed.push_back(instruction);
      result.functions[i].blocks[block].instructions = std::move(needed);
    }
  }
  dropNamesOfNothing(result);
  return result;
}

}  // namespace reprise

#include "compiler/ir/limit_loops.h"

#include <algorithm>
#include <unordered_set>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

class LoopLimiter {
 public:
  LoopLimiter(const Module& module, std::uint32_t most) : module_(module) {
    uint_ = uintType(module_);
    bool_ = findOrAddGlobal(module_, Op::OpTypeBool, 0, {});
    one_ = uintConstant(module_, 1);
    most_ = uintConstant(module_, most);
    const std::uint32_t zero = uintConstant(module_, 0), pointer = pointerType(module_, spv::StorageClass::Private, uint_);
    counter_ = module_.freshId();
    module_.globals.push_back(makeInstruction(Op::OpVariable, pointer, counter_,
                                              {literalOperand(static_cast<std::uint32_t>(spv::StorageClass::Private)), idOperand(zero)}));
    if (module_.version >= 0x00010400) module_.entry_points.front().operands.push_back(idOperand(counter_));
  }

  Module run() {
    for (const Function& function : module_.functions)
      for (const Block& block : function.blocks)
        for (const Instruction& instruction : block.instructions)
          if (instruction.opcode == Op::OpLoopMerge) merges_.insert(instruction.word(0));
    for (Function& function : module_.functions)
      for (Block& block : function.blocks) {
        countAt(block);
        leaveAt(block);
      }
    discardAtReturns(*findFunction(module_, module_.entry_points.front().word(1)));
    return std::move(module_);
  }

 private:
  void countAt(Block& block) {
    const auto merge = std::find_if(block.instructions.begin(), block.instructions.end(),
                                    [](const Instruction& one) { return one.opcode == Op::OpLoopMerge; });
    if (merge == block.instructions.end()) return;
    const std::uint32_t before = module_.freshId(), after = module_.freshId();
    const std::vector<Instruction> code = {makeInstruction(Op::OpLoad, uint_, before, {idOperand(counter_)}),
                                           makeInstruction(Op::OpIAdd, uint_, after, {idOperand(before), idOperand(one_)}),
                                           makeInstruction(Op::OpStore, 0, 0, {idOperand(counter_), idOperand(after)})};
    block.instructions.insert(merge, code.begin(), code.end());
  }

  // A conditional branch to a loop's merge block is taken there, too, where the count is too high.
  void leaveAt(Block& block) {
    if (block.terminator().opcode != Op::OpBranchConditional) return;
    const bool if_true = merges_.count(block.terminator().word(1)) != 0, if_false = merges_.count(block.terminator().word(2)) != 0;
    if (if_true == if_false) return;
    const std::uint32_t count = module_.freshId(), many = module_.freshId(), few = module_.freshId(), leaves = module_.freshId();
    const Operand condition = block.terminator().operands[0];
    const std::vector<Instruction> code = {
        makeInstruction(Op::OpLoad, uint_, count, {idOperand(counter_)}),
        makeInstruction(Op::OpUGreaterThan, bool_, many, {idOperand(count), idOperand(most_)}),
        makeInstruction(Op::OpLogicalNot, bool_, few, {idOperand(many)}),
        if_true ? makeInstruction(Op::OpLogicalOr, bool_, leaves, {condition, idOperand(many)})
                : makeInstruction(Op::OpLogicalAnd, bool_, leaves, {condition, idOperand(few)})};
    block.instructions.back().operands[0] = idOperand(leaves);
    auto at = block.instructions.end() - 1;
    if (at != block.instructions.begin() && ((at - 1)->opcode == Op::OpLoopMerge || (at - 1)->opcode == Op::OpSelectionMerge)) --at;
    block.instructions.insert(at, code.begin(), code.end());
  }

  void discardAtReturns(Function& entry) {
    std::vector<Block> blocks;
    for (Block& block : entry.blocks) {
      const bool returns = block.terminator().opcode == Op::OpReturn;
      blocks.push_back(std::move(block));
      if (!returns) continue;
      const std::uint32_t count = module_.freshId(), many = module_.freshId(), discard = module_.freshId(), leave = module_.freshId();
      std::vector<Instruction>& code = blocks.back().instructions;
      code.pop_back();
      code.push_back(makeInstruction(Op::OpLoad, uint_, count, {idOperand(counter_)}));
      code.push_back(makeInstruction(Op::OpUGreaterThan, bool_, many, {idOperand(count), idOperand(most_)}));
      code.push_back(makeInstruction(Op::OpSelectionMerge, 0, 0, {idOperand(leave), literalOperand(0)}));
      code.push_back(makeInstruction(Op::OpBranchConditional, 0, 0, {idOperand(many), idOperand(discard), idOperand(leave)}));
      blocks.push_back({discard, {makeInstruction(Op::OpKill, 0, 0, {})}});
      blocks.push_back({leave, {makeInstruction(Op::OpReturn, 0, 0, {})}});
    }
    entry.blocks = std::move(blocks);
  }

  Module module_;
  std::unordered_set<std::uint32_t> merges_;  // labels
  std::uint32_t uint_ = 0, bool_ = 0, one_ = 0, most_ = 0, counter_ = 0;
};

}  // namespace

Module limitLoops(const Module& module, std::uint32_t most) { return LoopLimiter(module, most).run(); }

}  // namespace reprise

#include "compiler/ir/single_return.h"

#include <algorithm>
#include <map>
#include <set>

#include "compiler/ir/builder.h"
#include "compiler/ir/constructs.h"
#include "compiler/ir/globals.h"
#include "compiler/ir/mend_dominance.h"
#include "compiler/ir/return_flags.h"
#include "compiler/ir/unreachable_blocks.h"

namespace reprise {
namespace {

using spv::Op;

bool returns(const Block& block) {
  return block.terminator().opcode == Op::OpReturn || block.terminator().opcode == Op::OpReturnValue;
}

std::uint32_t boolConstant(Module& module, bool value) {
  const std::uint32_t type = findOrAddGlobal(module, Op::OpTypeBool, 0, {});
  return findOrAddGlobal(module, value ? Op::OpConstantTrue : Op::OpConstantFalse, type, {});
}

struct Made {
  Function function;
  std::uint32_t value_variable = 0, flag_variable = 0;  // 0: none was needed
};

class ReturnMerger {
 public:
  ReturnMerger(Module& module, const Function& function)
      : module_(module), flow_(analyseControlFlow(function)), constructs_(function, flow_) {
    result_.function = function;
    return_type_ = function.definition.type_id;
  }

  std::optional<Function> run() {
    std::vector<int> returning;
    for (std::size_t block = 0; block < blocks().size(); ++block)
      if (flow_.reachable[block] && returns(blocks()[block])) returning.push_back(static_cast<int>(block));
    if (returning.empty()) return std::move(result_.function);
    if (returning.size() == 1 && !inAnyConstruct(returning.front())) {
      moveToEnd(returning.front());
      return std::move(result_.function);
    }
    for (const int block : returning)
      if (!leaves(block)) return std::nullopt;
    // A block that is never run ends like a return where that adds no flag, so that the function is left by its end alone.
    for (std::size_t block = 0; block < blocks().size(); ++block)
      if (blocks()[block].terminator().opcode == Op::OpUnreachable && leavesLikeReturns(static_cast<int>(block)))
        returning.push_back(static_cast<int>(block));
    end_ = module_.freshId();
    addVariables();
    for (const int block : returning) replaceReturn(block);
    testFlags();
    wrap();
    mendDominance(module_, result_.function);
    return std::move(result_.function);
  }

 private:
  std::vector<Block>& blocks() { return result_.function.blocks; }

  bool inAnyConstruct(int block) const {
    return std::any_of(constructs_.all().begin(), constructs_.all().end(),
                       [&](const Construct& construct) { return constructs_.contains(construct, block); });
  }

  // The blocks of a function may stand in any order that dominance allows; the return is to be the last.
  void moveToEnd(int block) {
    const auto at = blocks().begin() + block;
    std::rotate(at, at + 1, blocks().end());
  }

  // Marks the loops and switches that a return leaves. False in a continue construct; a merge block that is a continue target is
  // left before it is entered.
  bool leaves(int block) {
    for (const Construct* construct = constructs_.breakable(block); construct != nullptr; construct = constructs_.breakable(block)) {
      for (const Construct& loop : constructs_.all())
        if (constructs_.continues(loop, block) && loop.continue_target != block) return false;
      left_[construct->merge] = construct;
      block = construct->merge;
    }
    return true;
  }

  bool leavesLikeReturns(int block) const {
    for (const Construct& loop : constructs_.all())
      if (constructs_.continues(loop, block)) return false;
    const Construct* construct = constructs_.breakable(block);
    return construct == nullptr || left_.count(construct->merge) != 0;
  }

  // Where a block goes to leave what is around it.
  std::uint32_t wayOut(int block) const {
    const Construct* construct = constructs_.breakable(block);
    return construct == nullptr ? end_ : entrance_of_.at(construct->merge);
  }

  void addVariables() {
    const Instruction& type = *findGlobal(module_, return_type_);
    if (type.opcode != Op::OpTypeVoid) result_.value_variable = addLocal(return_type_);
    if (!left_.empty()) {
      result_.flag_variable = addLocal(findOrAddGlobal(module_, Op::OpTypeBool, 0, {}));
      addName(module_, result_.flag_variable, kReturnFlagName);
    }
    for (const auto& [merge, construct] : left_) entrance_of_[merge] = module_.freshId();
  }

  std::uint32_t addLocal(std::uint32_t type) {
    const std::uint32_t pointer = pointerType(module_, spv::StorageClass::Function, type), id = module_.freshId();
    variables_.push_back(
        makeInstruction(Op::OpVariable, pointer, id, {literalOperand(static_cast<std::uint32_t>(spv::StorageClass::Function))}));
    return id;
  }

  void replaceReturn(int index) {
    Block& block = blocks()[static_cast<std::size_t>(index)];
    const Instruction last = block.instructions.back();
    block.instructions.pop_back();
    Builder build(module_, block.instructions, last.line);
    if (last.opcode == Op::OpReturnValue) build.store(result_.value_variable, last.word(0));
    const bool breaks = constructs_.breakable(index) != nullptr;
    if (breaks) build.store(result_.flag_variable, boolConstant(module_, true));
    build.branch(wayOut(index));
    if (breaks) returned_into_[constructs_.breakable(index)->merge].push_back(block.label);
  }

  // A block before each merge block that a return goes through; all ways out of the construct lead there first.
  void testFlags() {
    // Inner ones first, so that the ways that they add to outer ones are known there.
    std::vector<int> merges;
    for (const auto& [merge, construct] : left_) merges.push_back(merge);
    std::sort(merges.begin(), merges.end(), [&](int a, int b) { return depthOf(a) > depthOf(b); });
    std::map<std::uint32_t, Block> entrances;  // by the merge block's label
    for (const int merge : merges) entrances[blocks()[static_cast<std::size_t>(merge)].label] = entranceOf(merge);
    std::vector<Block> placed;
    for (Block& block : blocks()) {
      if (const auto entrance = entrances.find(block.label); entrance != entrances.end()) placed.push_back(std::move(entrance->second));
      placed.push_back(std::move(block));
    }
    blocks() = std::move(placed);
  }

  int depthOf(int block) const {
    return static_cast<int>(std::count_if(constructs_.all().begin(), constructs_.all().end(),
                                          [&](const Construct& construct) { return constructs_.contains(construct, block); }));
  }

  Block entranceOf(int merge) {
    const Construct& construct = *left_.at(merge);
    Block& target = blocks()[static_cast<std::size_t>(merge)];
    Block entrance{entrance_of_.at(merge), {}};
    redirect(construct, target, entrance);
    Builder build(module_, entrance.instructions, target.instructions.front().line);
    const std::uint32_t boolean = findOrAddGlobal(module_, Op::OpTypeBool, 0, {});
    const std::uint32_t returned = build.load(boolean, result_.flag_variable);
    // Where the construct merges into the continue target of a loop around it, both ways leave that loop's body: no selection.
    const bool into_continue = std::any_of(constructs_.all().begin(), constructs_.all().end(),
                                           [&](const Construct& one) { return one.continue_target == merge; });
    if (!into_continue) build.mergeAt(target.label);
    build.branchIf(returned, wayOut(merge), target.label);
    if (const Construct* outer = constructs_.breakable(merge)) returned_into_[outer->merge].push_back(entrance.label);
    return entrance;
  }

  // The edges from within the construct; what the phis of the merge block took from them is gathered before it. Others stay: back
  // edges of a loop that begins there, and branches to it as a continue target.
  void redirect(const Construct& construct, Block& target, Block& entrance) {
    std::set<std::uint32_t> moved;  // labels of predecessors
    for (Block& block : blocks()) {
      if (!constructs_.contains(construct, flow_.block_of_label.at(block.label))) continue;
      bool leads = false;
      for (Instruction& instruction : block.instructions) {
        const bool states = instruction.opcode == Op::OpLoopMerge || instruction.opcode == Op::OpSelectionMerge;
        if (states ? block.label != header(construct) : targetsOf(instruction).empty()) continue;
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          Operand& operand = instruction.operands[i];
          if (!operand.is_id || operand.words[0] != target.label || (states && i > 0)) continue;
          operand.words[0] = entrance.label;
          leads |= !states;
        }
      }
      if (leads) moved.insert(block.label);
    }
    gatherPhis(target, entrance, moved, returned_into_[construct.merge]);
  }

  std::uint32_t header(const Construct& construct) { return blocks()[static_cast<std::size_t>(construct.header)].label; }

  void gatherPhis(Block& target, Block& entrance, const std::set<std::uint32_t>& moved, const std::vector<std::uint32_t>& returning) {
    for (Instruction& phi : target.instructions) {
      if (phi.opcode != Op::OpPhi) break;
      std::vector<Operand> gathered, kept;
      for (std::size_t i = 0; i + 1 < phi.operands.size(); i += 2) {
        std::vector<Operand>& to = moved.count(phi.word(i + 1)) != 0 ? gathered : kept;
        to.push_back(phi.operands[i]);
        to.push_back(phi.operands[i + 1]);
      }
      for (const std::uint32_t label : returning) {
        gathered.push_back(idOperand(undefinedValue(module_, phi.type_id)));
        gathered.push_back(idOperand(label));
      }
      const std::uint32_t value = module_.freshId();
      entrance.instructions.push_back(makeInstruction(Op::OpPhi, phi.type_id, value, std::move(gathered)));
      kept.push_back(idOperand(value));
      kept.push_back(idOperand(entrance.label));
      phi.operands = std::move(kept);
    }
  }

  void wrap() {
    Block first{module_.freshId(), variables_};
    std::vector<Instruction>& entry = blocks().front().instructions;
    const auto code = std::find_if(entry.begin(), entry.end(), [](const Instruction& one) { return one.opcode != Op::OpVariable; });
    first.instructions.insert(first.instructions.end(), entry.begin(), code);
    entry.erase(entry.begin(), code);
    Builder build(module_, first.instructions);
    if (result_.flag_variable != 0) build.store(result_.flag_variable, boolConstant(module_, false));
    build.mergeAt(end_);
    build.effect(Op::OpSwitch, {idOperand(uintConstant(module_, 0)), idOperand(blocks().front().label)});
    blocks().insert(blocks().begin(), std::move(first));
    Block last{end_, {}};
    Builder close(module_, last.instructions);
    if (result_.value_variable == 0) {
      close.effect(Op::OpReturn, {});
    } else {
      close.effect(Op::OpReturnValue, {idOperand(close.load(return_type_, result_.value_variable))});
    }
    blocks().push_back(std::move(last));
  }

  Module& module_;
  const ControlFlow flow_;
  const Constructs constructs_;
  Made result_;
  std::uint32_t return_type_ = 0;
  std::uint32_t end_ = 0;                                     // label
  std::map<int, const Construct*> left_;                      // loops and switches that returns leave, by merge block
  std::map<int, std::uint32_t> entrance_of_;                  // label of the block before such a merge block
  std::map<int, std::vector<std::uint32_t>> returned_into_;   // by merge block: labels of the blocks that come there with the flag set
  std::vector<Instruction> variables_;
};

}  // namespace

std::optional<Function> withSingleReturn(Module& module, const Function& function) {
  return ReturnMerger(module, function).run();
}

}  // namespace reprise

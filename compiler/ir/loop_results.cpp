#include "compiler/ir/loop_results.h"

#include <algorithm>

#include "compiler/ir/control_flow.h"
#include "compiler/ir/payload_type.h"

namespace reprise {
namespace {

using spv::Op;

// The merge block of a loop; kNoBlock where the header states none.
int mergeOf(const Function& function, const ControlFlow& flow, const Loop& loop) {
  for (const Instruction& instruction : function.blocks[static_cast<std::size_t>(loop.header)].instructions)
    if (instruction.opcode == Op::OpLoopMerge)
      if (const auto found = flow.block_of_label.find(instruction.word(0)); found != flow.block_of_label.end()) return found->second;
  return kNoBlock;
}

class LoopCloser {
 public:
  LoopCloser(Module& module, std::uint32_t function) : module_(module), function_(*findFunction(module, function)) {
    flow_ = analyseControlFlow(function_);
    numberDominators();
    for (std::size_t block = 0; block < function_.blocks.size(); ++block) {
      const bool reachable = flow_.reachable[block];
      for (const Instruction& instruction : function_.blocks[block].instructions)
        if (reachable && instruction.result_id != 0 && payloadType(module, instruction.type_id).channels > 0) defined_in_[instruction.result_id] = static_cast<int>(block);
    }
  }

  std::unordered_map<std::uint32_t, std::uint32_t> run() {
    std::size_t instructions = 0;
    for (const Block& block : function_.blocks) instructions += block.instructions.size();
    if (flow_.loops.size() * instructions > kMostLoopsTimesInstructions) return {};
    std::vector<const Loop*> loops;
    for (const Loop& loop : flow_.loops) loops.push_back(&loop);
    const auto size = [](const Loop* loop) { return std::count(loop->contains.begin(), loop->contains.end(), true); };
    std::stable_sort(loops.begin(), loops.end(), [&](const Loop* a, const Loop* b) { return size(a) < size(b); });
    for (const Loop* loop : loops) close(*loop);
    return std::move(result_of_);
  }

 private:
  // Intervals of a walk of the dominator tree: a block dominates those whose interval lies in its own.
  void numberDominators() {
    const std::size_t count = function_.blocks.size();
    std::vector<std::vector<int>> children(count);
    for (std::size_t block = 0; block < count; ++block)
      if (const int parent = flow_.immediate_dominator[block]; parent != kNoBlock) children[static_cast<std::size_t>(parent)].push_back(static_cast<int>(block));
    enter_.assign(count, 0);
    leave_.assign(count, 0);
    int clock = 0;
    std::vector<std::pair<int, std::size_t>> stack{{0, 0}};
    enter_[0] = ++clock;
    while (!stack.empty()) {
      auto& [block, next] = stack.back();
      const auto& below = children[static_cast<std::size_t>(block)];
      if (next == below.size()) {
        leave_[static_cast<std::size_t>(block)] = ++clock;
        stack.pop_back();
        continue;
      }
      const int child = below[next++];
      enter_[static_cast<std::size_t>(child)] = ++clock;
      stack.push_back({child, 0});
    }
  }

  bool isDominated(int dominator, int block) const {
    const auto a = static_cast<std::size_t>(dominator), b = static_cast<std::size_t>(block);
    return enter_[a] != 0 && enter_[b] != 0 && enter_[a] <= enter_[b] && leave_[b] <= leave_[a];
  }

  void close(const Loop& loop) {
    const int merge = mergeOf(function_, flow_, loop);
    if (merge == kNoBlock || loop.contains[static_cast<std::size_t>(merge)] || !flow_.reachable[static_cast<std::size_t>(merge)]) return;
    // Loop value -> phi, in the order of first use so that ids repeat from run to run.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> phis;
    std::unordered_map<std::uint32_t, std::uint32_t> phi_of;
    for (std::size_t block = 0; block < function_.blocks.size(); ++block)
      if (!loop.contains[block] && flow_.reachable[block] && isDominated(merge, static_cast<int>(block)))
        for (Instruction& instruction : function_.blocks[block].instructions) {
          // What a phi of the merge block takes is used on the way there, not in it.
          if (instruction.opcode == Op::OpPhi && static_cast<int>(block) == merge) continue;
          for (Operand& operand : instruction.operands) {
            if (!operand.is_id || !leaves(loop, merge, operand.words[0])) continue;
            const std::uint32_t value = operand.words[0];
            const auto [phi, added] = phi_of.emplace(value, 0);
            if (added) phis.push_back({value, phi->second = module_.freshId()});
            operand.words[0] = phi->second;
          }
        }
    insertPhis(merge, phis);
  }

  bool leaves(const Loop& loop, int merge, std::uint32_t id) const {
    const auto defined = defined_in_.find(id);
    if (defined == defined_in_.end() || !loop.contains[static_cast<std::size_t>(defined->second)]) return false;
    return defined->second != merge && isDominated(defined->second, merge);
  }

  void insertPhis(int merge, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& phis) {
    Block& block = function_.blocks[static_cast<std::size_t>(merge)];
    std::vector<Instruction> code;
    for (const auto& [value, phi] : phis) {
      const Instruction& definition = definitionOf(value);
      Instruction made = makeInstruction(Op::OpPhi, definition.type_id, phi, {});
      made.line = definition.line;
      for (const int predecessor : flow_.predecessors[static_cast<std::size_t>(merge)]) {
        made.operands.push_back(idOperand(value));
        made.operands.push_back(idOperand(function_.blocks[static_cast<std::size_t>(predecessor)].label));
      }
      code.push_back(std::move(made));
      defined_in_[phi] = merge;
      result_of_[value] = phi;
    }
    block.instructions.insert(block.instructions.begin(), code.begin(), code.end());
  }

  const Instruction& definitionOf(std::uint32_t value) const {
    const Block& block = function_.blocks[static_cast<std::size_t>(defined_in_.at(value))];
    const auto found = std::find_if(block.instructions.begin(), block.instructions.end(),
                                    [&](const Instruction& one) { return one.result_id == value; });
    REPRISE_CHECK(found != block.instructions.end(), value);
    return *found;
  }

  Module& module_;
  Function& function_;
  ControlFlow flow_;
  std::vector<int> enter_, leave_;  // by block; 0: not reached
  std::unordered_map<std::uint32_t, int> defined_in_;  // block, by value
  std::unordered_map<std::uint32_t, std::uint32_t> result_of_;
};

}  // namespace

LoopClosed closeLoops(const Module& module, std::uint32_t function) {
  LoopClosed closed{module, {}};
  closed.result_of = LoopCloser(closed.module, function).run();
  return closed;
}

}  // namespace reprise

#include "compiler/ir/unroll.h"

#include <algorithm>
#include <vector>

#include "compiler/ir/control_flow.h"
#include "compiler/ir/fold_constants.h"
#include "compiler/ir/optimize.h"
#include "compiler/ir/promote_to_ssa.h"
#include "compiler/ir/trip_count.h"

namespace reprise {
namespace {

using spv::Op;

bool contains(const Loop& outer, const Loop& inner) {
  return &outer != &inner && outer.contains[static_cast<std::size_t>(inner.header)];
}

// Instructions of a loop written out; more than the limit where a loop in it has no constant trip count.
std::int64_t unrolledInstructions(const Function& function, const ControlFlow& flow, const Loop& loop, const std::vector<int>& trip_counts) {
  std::int64_t total = 0;
  for (std::size_t block = 0; block < function.blocks.size(); ++block) {
    if (!loop.contains[block]) continue;
    auto instructions = static_cast<std::int64_t>(function.blocks[block].instructions.size());
    for (std::size_t other = 0; other < flow.loops.size(); ++other)
      if (flow.loops[other].contains[block] && (&flow.loops[other] == &loop || contains(loop, flow.loops[other])))
        instructions = std::min<std::int64_t>(instructions * trip_counts[other], std::int64_t{1} << 40);
    total += instructions;
  }
  return total;
}

Instruction* mergeInstruction(Function& function, const Loop& loop) {
  for (Instruction& instruction : function.blocks[static_cast<std::size_t>(loop.header)].instructions)
    if (instruction.opcode == Op::OpLoopMerge) return &instruction;
  return nullptr;
}

// A long loop that only the variants unroll lets the driver fold what it does not in the original, which may round otherwise (law 1).
int mostInstructions(const Instruction& merge) {
  const bool requested = (merge.word(2) & static_cast<std::uint32_t>(spv::LoopControlMask::Unroll)) != 0;
  return requested ? kMostInstructionsUnrolledOnRequest : kMostUnrolledInstructions;
}

// Asks SPIRV-Tools for the loops to unroll by their own loop control. Returns whether there are any.
bool markLoops(Module& module, std::uint32_t function_id) {
  Function& function = *findFunction(module, function_id);
  std::size_t instructions = 0;
  for (const Block& block : function.blocks) instructions += block.instructions.size();
  if (instructions > kMostInstructionsToUnroll) return false;
  const ControlFlow flow = analyseControlFlow(function);
  if (flow.loops.size() > kMostLoops) return false;
  std::vector<int> trip_counts;
  for (const Loop& loop : flow.loops) trip_counts.push_back(constantTripCount(module, function, flow, loop).value_or(1 << 20));
  bool any = false;
  for (std::size_t i = 0; i < flow.loops.size(); ++i) {
    Instruction* merge = mergeInstruction(function, flow.loops[i]);
    if (merge == nullptr) continue;
    const bool unrolled = trip_counts[i] <= kMostUnrolledIterations &&
                          unrolledInstructions(function, flow, flow.loops[i], trip_counts) <= mostInstructions(*merge);
    any |= unrolled;
    merge->operands.resize(3);
    merge->operands[2] = literalOperand(static_cast<std::uint32_t>(unrolled ? spv::LoopControlMask::Unroll : spv::LoopControlMask::MaskNone));
  }
  return any;
}

}  // namespace

Result<Module> unrollShortLoops(const Module& module, std::uint32_t function) {
  Module marked = module;
  if (!markLoops(marked, function)) return module;
  REPRISE_ASSIGN(const Module unrolled, unrollMarkedLoops(marked));
  return promoteToSsa(foldConstants(unrolled));
}

}  // namespace reprise

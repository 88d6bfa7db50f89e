#include "compiler/ir/trip_count.h"

#include <algorithm>

namespace reprise {
namespace {

using spv::Op;

const Instruction* constantOf(const Module& module, std::uint32_t id) {
  const Instruction* global = findGlobal(module, id);
  return global != nullptr && global->opcode == Op::OpConstant ? global : nullptr;
}

const Instruction* definitionIn(const Function& function, std::uint32_t id) {
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.result_id == id) return &instruction;
  return nullptr;
}

// How often `compare(i, limit)` holds for i = first, first + step, ...; 0 where that is not clear.
int countedIterations(Op compare, std::int64_t first, std::int64_t step, std::int64_t limit) {
  std::int64_t last = limit;
  switch (compare) {
    case Op::OpSLessThan:
    case Op::OpULessThan: last = limit - 1; break;
    case Op::OpSGreaterThan:
    case Op::OpUGreaterThan: last = limit + 1; break;
    case Op::OpSLessThanEqual:
    case Op::OpULessThanEqual:
    case Op::OpSGreaterThanEqual:
    case Op::OpUGreaterThanEqual: break;
    default: return 0;
  }
  if (step == 0 || (step > 0) != (last >= first)) return step != 0 && first == last ? 1 : 0;
  return static_cast<int>(std::min<std::int64_t>((last - first) / step + 1, 1 << 20));
}

// Whether a block's branch on `condition` may leave the loop.
bool leavesLoop(const Function& function, const ControlFlow& flow, const Loop& loop, std::uint32_t condition) {
  for (std::size_t block = 0; block < function.blocks.size(); ++block) {
    const Instruction& branch = function.blocks[block].terminator();
    if (!loop.contains[block] || branch.opcode != Op::OpBranchConditional || branch.word(0) != condition) continue;
    for (const int successor : flow.successors[block])
      if (!loop.contains[static_cast<std::size_t>(successor)]) return true;
  }
  return false;
}

}  // namespace

std::optional<int> constantTripCount(const Module& module, const Function& function, const ControlFlow& flow, const Loop& loop) {
  const Block& header = function.blocks[static_cast<std::size_t>(loop.header)];
  for (const Instruction& phi : header.instructions) {
    if (phi.opcode != Op::OpPhi) break;
    const Instruction* first = nullptr;
    const Instruction* step = nullptr;
    Op step_opcode = Op::OpNop;
    for (std::size_t i = 0; i + 1 < phi.operands.size(); i += 2) {
      const auto from = flow.block_of_label.find(phi.word(i + 1));
      if (from == flow.block_of_label.end()) continue;
      if (!loop.contains[static_cast<std::size_t>(from->second)]) {
        first = constantOf(module, phi.word(i));
      } else if (const Instruction* next = definitionIn(function, phi.word(i));
                 next != nullptr && (next->opcode == Op::OpIAdd || next->opcode == Op::OpISub) &&
                 next->word(0) == phi.result_id) {
        step = constantOf(module, next->word(1));
        step_opcode = next->opcode;
      }
    }
    if (first == nullptr || step == nullptr) continue;
    const std::int64_t step_value = std::int64_t{static_cast<std::int32_t>(step->word(0))} * (step_opcode == Op::OpISub ? -1 : 1);
    for (std::size_t block = 0; block < function.blocks.size(); ++block) {
      if (!loop.contains[block]) continue;
      for (const Instruction& compare : function.blocks[block].instructions) {
        if (compare.operands.size() != 2 || compare.type_id == 0 || compare.word(0) != phi.result_id) continue;
        if (!leavesLoop(function, flow, loop, compare.result_id)) continue;
        const Instruction* limit = compare.operands[1].is_id ? constantOf(module, compare.word(1)) : nullptr;
        if (limit == nullptr) continue;
        const int count = countedIterations(compare.opcode, static_cast<std::int32_t>(first->word(0)), step_value,
                                            static_cast<std::int32_t>(limit->word(0)));
        if (count > 0) return count;
      }
    }
  }
  return std::nullopt;
}

}  // namespace reprise

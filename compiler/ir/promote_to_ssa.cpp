#include "compiler/ir/promote_to_ssa.h"

#include <algorithm>

#include "compiler/ir/fold_composites.h"
#include "compiler/ir/promote_variables.h"
#include "compiler/ir/remove_unused.h"
#include "compiler/ir/split_variables.h"
#include "compiler/ir/unreachable_blocks.h"

namespace reprise {
namespace {

bool hasLocals(const Function& function) {
  const std::vector<Instruction>& first = function.blocks.front().instructions;
  return std::any_of(first.begin(), first.end(), [](const Instruction& one) { return one.opcode == spv::Op::OpVariable; });
}

}  // namespace

Result<Module> promoteToSsa(const Module& module) {
  Module result = module;
  for (Function& function : result.functions)
    if (!function.blocks.empty()) removeUnreachableBlocks(result, function);
  result = removeUnused(result);
  for (std::size_t i = 0; i < result.functions.size(); ++i) {
    const std::uint32_t function = result.functions[i].id();
    // Twice: an index that was a variable may be a constant the second time.
    for (int turn = 0; turn < 2 && !result.functions[i].blocks.empty() && hasLocals(result.functions[i]); ++turn)
      result = removeUnused(foldComposites(promoteVariables(splitVariables(result, function), function), function));
  }
  return result;
}

}  // namespace reprise

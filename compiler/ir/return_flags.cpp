#include "compiler/ir/return_flags.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace reprise {
namespace {

using spv::Op;

bool isFlagName(const Instruction& name) { return name.opcode == Op::OpName && stringOf(name.operands[1]) == kReturnFlagName; }

}  // namespace

bool hasReturnFlags(const Module& module) { return std::any_of(module.names.begin(), module.names.end(), isFlagName); }

std::unordered_set<std::uint32_t> flagsOfReturns(const Module& module, std::uint32_t function) {
  std::unordered_set<std::uint32_t> booleans, constants;
  for (const Instruction& global : module.globals) {
    if (global.opcode == Op::OpTypeBool) booleans.insert(global.result_id);
    if (global.opcode == Op::OpConstantTrue || global.opcode == Op::OpConstantFalse || global.opcode == Op::OpUndef) constants.insert(global.result_id);
  }
  std::vector<const Instruction*> phis;
  std::unordered_set<std::uint32_t> flags;
  for (const Block& block : findFunction(module, function)->blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.opcode == Op::OpPhi && booleans.count(instruction.type_id) != 0) {
        phis.push_back(&instruction);
        flags.insert(instruction.result_id);
      }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Instruction* phi : phis) {
      if (flags.count(phi->result_id) == 0) continue;
      for (std::size_t i = 0; i < phi->operands.size(); i += 2)
        if (constants.count(phi->word(i)) == 0 && flags.count(phi->word(i)) == 0) {
          changed = flags.erase(phi->result_id) != 0;
          break;
        }
    }
  }
  return flags;
}

void dropReturnFlagNames(Module& module) { std::erase_if(module.names, isFlagName); }

}  // namespace reprise

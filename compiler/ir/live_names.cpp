#include "compiler/ir/live_names.h"

#include <vector>

namespace reprise {
namespace {

using spv::Op;

std::vector<bool> definedIds(const Module& module) {
  std::vector<bool> defined(module.bound, false);
  const auto define = [&](const Instruction& instruction) { defined[instruction.result_id] = true; };
  for (const auto* section : {&module.imports, &module.debug_sources, &module.annotations, &module.globals})
    for (const Instruction& instruction : *section) define(instruction);
  for (const Function& function : module.functions) {
    define(function.definition);
    for (const Instruction& parameter : function.parameters) define(parameter);
    for (const Block& block : function.blocks) {
      defined[block.label] = true;
      for (const Instruction& instruction : block.instructions) define(instruction);
    }
  }
  return defined;
}

}  // namespace

void dropNamesOfNothing(Module& module) {
  const std::vector<bool> defined = definedIds(module);
  const auto targets_nothing = [&](const Instruction& about) {
    return !about.operands.empty() && about.operands[0].is_id && !defined[about.word(0)];
  };
  std::erase_if(module.names, targets_nothing);
  std::erase_if(module.annotations, targets_nothing);
  for (Instruction& about : module.annotations)
    if (about.opcode == Op::OpGroupDecorate)
      std::erase_if(about.operands, [&](const Operand& target) { return target.is_id && !defined[target.words[0]]; });
}

}  // namespace reprise

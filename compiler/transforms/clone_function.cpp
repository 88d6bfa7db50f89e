#include "compiler/transforms/clone_function.h"

namespace reprise {
namespace {

using Ids = std::unordered_map<std::uint32_t, std::uint32_t>;

void copyAbout(std::vector<Instruction>& instructions, const Ids& copy_of) {
  const std::size_t count = instructions.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (instructions[i].operands.empty() || !instructions[i].operands[0].is_id) continue;
    const auto copy = copy_of.find(instructions[i].word(0));
    if (copy == copy_of.end()) continue;
    Instruction duplicate = instructions[i];
    duplicate.operands[0].words[0] = copy->second;
    instructions.push_back(std::move(duplicate));
  }
}

}  // namespace

ClonedFunction cloneFunction(const Module& module, std::uint32_t function) {
  ClonedFunction result{module, 0, {}};
  const Function* original = findFunction(module, function);
  REPRISE_CHECK(original != nullptr, function);
  Function copy = *original;
  const auto renew = [&](std::uint32_t& id) {
    if (id == 0) return;
    const std::uint32_t fresh = result.module.freshId();
    result.copy_of[id] = fresh;
    id = fresh;
  };
  renew(copy.definition.result_id);
  for (Instruction& parameter : copy.parameters) renew(parameter.result_id);
  for (Block& block : copy.blocks) {
    renew(block.label);
    for (Instruction& instruction : block.instructions) renew(instruction.result_id);
  }
  for (Block& block : copy.blocks)
    for (Instruction& instruction : block.instructions)
      for (Operand& operand : instruction.operands)
        if (operand.is_id)
          if (const auto fresh = result.copy_of.find(operand.words[0]); fresh != result.copy_of.end())
            operand.words[0] = fresh->second;
  copyAbout(result.module.names, result.copy_of);
  copyAbout(result.module.annotations, result.copy_of);
  result.function = copy.id();
  result.module.functions.push_back(std::move(copy));
  return result;
}

Module addEntryPoint(const Module& module, std::uint32_t function, const std::string& name, std::uint32_t like) {
  Module result = module;
  for (const Instruction& entry : module.entry_points) {
    if (entry.word(1) != like) continue;
    Instruction copy = entry;
    copy.operands[1] = idOperand(function);
    copy.operands[2] = stringOperand(name);
    result.entry_points.push_back(std::move(copy));
  }
  for (const Instruction& mode : module.execution_modes) {
    if (mode.word(0) != like) continue;
    Instruction copy = mode;
    copy.operands[0] = idOperand(function);
    result.execution_modes.push_back(std::move(copy));
  }
  return result;
}

}  // namespace reprise

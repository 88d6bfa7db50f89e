#include "cli/check/undefined_values.h"

#include <algorithm>
#include <set>

namespace reprise {
namespace {

using spv::Op;

constexpr std::uint32_t kUndefinedComponent = 0xffffffffu;

bool isUninitialized(const Instruction& instruction, spv::StorageClass storage) {
  return instruction.opcode == Op::OpVariable && static_cast<spv::StorageClass>(instruction.word(0)) == storage && instruction.operands.size() == 1;
}

// Passes leave undefined values behind that nothing takes.
std::set<std::uint32_t> usedIds(const Module& module) {
  std::set<std::uint32_t> used;
  const auto addOperands = [&](const Instruction& instruction) {
    for (const Operand& operand : instruction.operands)
      if (operand.is_id) used.insert(operand.words[0]);
  };
  std::for_each(module.globals.begin(), module.globals.end(), addOperands);
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks) std::for_each(block.instructions.begin(), block.instructions.end(), addOperands);
  return used;
}

bool isUndefined(const Instruction& instruction, const std::set<std::uint32_t>& used) {
  if (instruction.opcode == Op::OpUndef) return used.count(instruction.result_id) != 0;
  if (isUninitialized(instruction, spv::StorageClass::Function)) return true;
  if (instruction.opcode != Op::OpVectorShuffle) return false;
  return std::any_of(instruction.operands.begin() + 2, instruction.operands.end(), [](const Operand& operand) { return operand.words[0] == kUndefinedComponent; });
}

// Stored as a whole in the first block, or in the only one that returns.
std::set<std::uint32_t> storedForSure(const Function& function) {
  const auto returns = [](const Block& block) { return block.terminator().opcode == Op::OpReturn; };
  const bool one_return = std::count_if(function.blocks.begin(), function.blocks.end(), returns) == 1;
  std::set<std::uint32_t> stored;
  for (std::size_t i = 0; i < function.blocks.size(); ++i) {
    const Block& block = function.blocks[i];
    if (i > 0 && !(one_return && returns(block))) continue;
    for (const Instruction& instruction : block.instructions)
      if (instruction.opcode == Op::OpStore) stored.insert(instruction.word(0));
  }
  return stored;
}

std::set<std::uint32_t> readVariables(const Function& function) {
  std::set<std::uint32_t> read;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.opcode == Op::OpLoad || instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpCopyMemory)
        for (const Operand& operand : instruction.operands)
          if (operand.is_id) read.insert(operand.words[0]);
  return read;
}

}  // namespace

bool mayShowUndefined(const PreparedShader& shader) {
  const Module& module = shader.module;
  const std::set<std::uint32_t> used = usedIds(module);
  const auto undefined = [&](const Instruction& instruction) { return isUndefined(instruction, used); };
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks)
      if (std::any_of(block.instructions.begin(), block.instructions.end(), undefined)) return true;
  const Function* entry = findFunction(module, shader.entry_function);
  if (entry == nullptr || entry->blocks.empty()) return true;
  const std::set<std::uint32_t> stored = storedForSure(*entry), read = readVariables(*entry);
  return std::any_of(module.globals.begin(), module.globals.end(), [&](const Instruction& global) {
    if (undefined(global) || isUninitialized(global, spv::StorageClass::Private)) return true;
    const bool is_output = isUninitialized(global, spv::StorageClass::Output);
    return is_output && (stored.count(global.result_id) == 0 || read.count(global.result_id) != 0);
  });
}

}  // namespace reprise

#include "compiler/ir/private_variables.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

struct PrivateVariable {
  Instruction definition;
  std::uint32_t function = 0;  // the one that uses it; 0: none yet
  bool stays = false;
};

bool isAccess(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain || opcode == Op::OpCopyObject; }

class Mover {
 public:
  explicit Mover(const Module& module) : module_(module) {
    for (const Instruction& global : module.globals)
      if (global.opcode == Op::OpVariable && static_cast<StorageClass>(global.word(0)) == StorageClass::Private)
        variables_[global.result_id] = {global};
    for (const Instruction& global : module.globals)
      for (const Operand& operand : global.operands)
        if (operand.is_id) keep(operand.words[0]);
  }

  Module run() {
    if (variables_.empty()) return std::move(module_);
    for (const Function& function : module_.functions) findUses(function);
    for (Function& function : module_.functions) move(function);
    return std::move(module_);
  }

 private:
  void keep(std::uint32_t id) {
    if (const auto found = variables_.find(id); found != variables_.end()) found->second.stays = true;
  }

  void findUses(const Function& function) {
    const bool entry = std::any_of(module_.entry_points.begin(), module_.entry_points.end(),
                                   [&](const Instruction& one) { return one.word(1) == function.id(); });
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        for (const Operand& operand : instruction.operands) {
          const auto found = operand.is_id ? variables_.find(operand.words[0]) : variables_.end();
          if (found == variables_.end()) continue;
          PrivateVariable& variable = found->second;
          variable.stays |= !entry || (variable.function != 0 && variable.function != function.id());
          variable.function = function.id();
        }
  }

  void move(Function& function) {
    std::vector<Instruction> variables, stores;
    std::set<std::uint32_t> moved;
    // In the order of the module, so that ids repeat from run to run.
    const std::vector<Instruction> globals = module_.globals;
    for (const Instruction& global : globals) {
      const auto found = variables_.find(global.result_id);
      if (found == variables_.end() || found->second.stays || found->second.function != function.id()) continue;
      Instruction local = global;
      local.type_id = localPointer(global.type_id);
      local.operands = {literalOperand(static_cast<std::uint32_t>(StorageClass::Function))};
      local.line = {};
      variables.push_back(std::move(local));
      if (global.operands.size() > 1) stores.push_back(makeInstruction(Op::OpStore, 0, 0, {idOperand(global.result_id), global.operands[1]}));
      moved.insert(global.result_id);
    }
    if (moved.empty()) return;
    std::erase_if(module_.globals, [&](const Instruction& global) { return moved.count(global.result_id) != 0; });
    for (Instruction& entry : module_.entry_points)
      for (std::size_t i = entry.operands.size(); i-- > 3;)
        if (moved.count(entry.word(i)) != 0) entry.operands.erase(entry.operands.begin() + static_cast<std::ptrdiff_t>(i));
    std::vector<Instruction>& first = function.blocks.front().instructions;
    const auto code = std::find_if(first.begin(), first.end(), [](const Instruction& one) { return one.opcode != Op::OpVariable; });
    first.insert(code, stores.begin(), stores.end());
    first.insert(first.begin(), variables.begin(), variables.end());
    retype(function, std::move(moved));
  }

  std::uint32_t localPointer(std::uint32_t type_id) { return pointerType(module_, StorageClass::Function, findGlobal(module_, type_id)->word(1)); }

  // Pointers into what moved.
  void retype(Function& function, std::set<std::uint32_t> pointers) {
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions) {
        if (!isAccess(instruction.opcode) || pointers.count(instruction.word(0)) == 0) continue;
        instruction.type_id = localPointer(instruction.type_id);
        pointers.insert(instruction.result_id);
      }
  }

  Module module_;
  std::unordered_map<std::uint32_t, PrivateVariable> variables_;  // by id
};

}  // namespace

Module privatesToLocals(const Module& module) { return Mover(module).run(); }

}  // namespace reprise

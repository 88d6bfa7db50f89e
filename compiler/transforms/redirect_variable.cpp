#include "compiler/transforms/redirect_variable.h"

#include <unordered_map>

#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

bool isAccess(Op opcode) { return opcode == Op::OpAccessChain || opcode == Op::OpInBoundsAccessChain; }

StorageClass storageOf(const Module& module, std::uint32_t variable) {
  return static_cast<StorageClass>(findGlobal(module, variable)->word(0));
}

bool namesMember(const Module& module, const Instruction& access, std::uint32_t member) {
  const Instruction* index = findGlobal(module, access.word(1));
  return index != nullptr && index->opcode == Op::OpConstant && index->word(0) == member;
}

Error unsupportedUse(const Module& module, std::uint32_t variable) {
  return {ErrorKind::kRefused, "variable.use",
          "the shader uses '" + nameOf(module, variable) + "' in a way that cannot be redirected", {}};
}

}  // namespace

Result<Module> redirectVariable(const Module& module, const Redirection& redirection) {
  Module result = module;
  const StorageClass storage = storageOf(module, redirection.to);
  std::unordered_map<std::uint32_t, bool> derived;  // pointers into `to`
  std::vector<Operand> prefix;
  for (const std::uint32_t member : redirection.prefix) prefix.push_back(idOperand(intConstant(result, static_cast<std::int32_t>(member))));
  Function* function = findFunction(result, redirection.function);
  REPRISE_CHECK(function != nullptr, redirection.function);
  for (Block& block : function->blocks)
    for (Instruction& instruction : block.instructions) {
      if (isAccess(instruction.opcode)) {
        const std::uint32_t base = instruction.word(0);
        if (base != redirection.from && derived.count(base) == 0) continue;
        if (base == redirection.from && redirection.drop_member && !namesMember(result, instruction, *redirection.drop_member)) continue;
        const std::uint32_t pointee = findGlobal(result, instruction.type_id)->word(1);
        instruction.type_id = pointerType(result, storage, pointee);
        derived[instruction.result_id] = true;
        if (base != redirection.from) continue;
        instruction.operands[0] = idOperand(redirection.to);
        if (redirection.drop_member) instruction.operands.erase(instruction.operands.begin() + 1);
        instruction.operands.insert(instruction.operands.begin() + 1, prefix.begin(), prefix.end());
        continue;
      }
      const bool direct = instruction.opcode == Op::OpLoad || instruction.opcode == Op::OpStore;
      for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
        Operand& operand = instruction.operands[i];
        if (!operand.is_id || operand.words[0] != redirection.from) continue;
        if (!direct || i != 0 || !prefix.empty() || redirection.drop_member) return unsupportedUse(module, redirection.from);
        operand.words[0] = redirection.to;
      }
    }
  return result;
}

Result<Module> hideOutputs(const Module& module, std::uint32_t function, HiddenOutputs hiding, std::uint32_t except) {
  Module result = module;
  for (const Instruction& global : module.globals) {
    if (global.opcode != Op::OpVariable || static_cast<StorageClass>(global.word(0)) != StorageClass::Output) continue;
    if (global.result_id == except) continue;
    if (hiding == HiddenOutputs::kColors && !decorationOf(module, global.result_id, spv::Decoration::Location)) continue;
    const std::uint32_t pointee = findGlobal(module, global.type_id)->word(1);
    const std::uint32_t hidden = addVariable(result, StorageClass::Private, pointee, nameOf(module, global.result_id) + "_unseen");
    REPRISE_ASSIGN(result, redirectVariable(result, {function, global.result_id, hidden, {}, {}}));
  }
  return result;
}

}  // namespace reprise

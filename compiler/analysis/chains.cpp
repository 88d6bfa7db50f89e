#include "compiler/analysis/chains.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace reprise {
namespace {

using spv::Op;

std::optional<ChainKind> kindOf(const Instruction& instruction, std::uint32_t standard_set) {
  switch (instruction.opcode) {
    case Op::OpFAdd:
    case Op::OpFSub: return ChainKind::kSum;
    case Op::OpFMul: return ChainKind::kProduct;
    case Op::OpExtInst:
      if (instruction.word(0) != standard_set) return std::nullopt;
      switch (instruction.word(1)) {
        case GLSLstd450FMin:
        case GLSLstd450NMin: return ChainKind::kMinimum;
        case GLSLstd450FMax:
        case GLSLstd450NMax: return ChainKind::kMaximum;
        default: return std::nullopt;
      }
    default: return std::nullopt;
  }
}

std::uint32_t standardSet(const Module& module) {
  for (const Instruction& import : module.imports)
    if (stringOf(import.operands[0]) == "GLSL.std.450") return import.result_id;
  return 0;
}

class ChainFinder {
 public:
  ChainFinder(const Module& module, const Function& function) : function_(function), standard_set_(standardSet(module)) {
    for (const Instruction& annotation : module.annotations)
      if (annotation.opcode == Op::OpDecorate && annotation.word(1) == static_cast<std::uint32_t>(spv::Decoration::NoContraction))
        exact_.insert(annotation.word(0));
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions) {
        if (instruction.result_id != 0) definitions_[instruction.result_id] = &instruction;
        for (const Operand& operand : instruction.operands)
          if (operand.is_id) ++uses_[operand.words[0]];
      }
  }

  std::vector<Chain> run() {
    std::vector<Chain> chains;
    for (const Block& block : function_.blocks)
      for (const Instruction& instruction : block.instructions) markInner(instruction);
    for (const Block& block : function_.blocks)
      for (const Instruction& instruction : block.instructions) {
        const auto kind = kindOf(instruction, standard_set_);
        if (!kind || inner_.count(instruction.result_id) != 0 || exact_.count(instruction.result_id) != 0) continue;
        Chain chain{*kind, instruction.result_id, {}};
        collect(instruction, chain);
        if (chain.terms.size() >= 3) chains.push_back(std::move(chain));
      }
    return chains;
  }

 private:
  // The operation that defines a term, if it is one more link of the chain of `user`.
  const Instruction* link(const Instruction& user, std::uint32_t term) const {
    const auto found = definitions_.find(term);
    if (found == definitions_.end() || uses_.at(term) != 1 || exact_.count(term) != 0) return nullptr;
    const Instruction& definition = *found->second;
    const bool same = kindOf(definition, standard_set_) == kindOf(user, standard_set_) && definition.type_id == user.type_id;
    return same && kindOf(user, standard_set_) ? &definition : nullptr;
  }

  void markInner(const Instruction& user) {
    if (!kindOf(user, standard_set_) || exact_.count(user.result_id) != 0) return;
    const std::size_t first = firstOperand(user);
    for (const std::size_t at : {first, first + 1})
      if (link(user, user.word(at)) != nullptr) inner_.insert(user.word(at));
  }

  // Leaves from left to right. Without recursion: generated shaders have chains of thousands of links.
  void collect(const Instruction& root, Chain& chain) const {
    struct Pending {
      const Instruction* user;
      std::uint32_t value;
      bool negative;
    };
    std::vector<Pending> stack;
    const auto expand = [&](const Instruction& operation, bool negative) {
      const std::size_t first = firstOperand(operation);
      const bool subtracts = operation.opcode == Op::OpFSub;
      stack.push_back({&operation, operation.word(first + 1), negative != subtracts});
      stack.push_back({&operation, operation.word(first), negative});
    };
    expand(root, false);
    while (!stack.empty()) {
      const Pending term = stack.back();
      stack.pop_back();
      if (const Instruction* inner = link(*term.user, term.value)) {
        expand(*inner, term.negative);
      } else {
        chain.terms.push_back({term.value, term.negative});
      }
    }
  }

  const Function& function_;
  std::uint32_t standard_set_;
  std::unordered_map<std::uint32_t, const Instruction*> definitions_;
  std::unordered_map<std::uint32_t, int> uses_;
  std::unordered_set<std::uint32_t> exact_, inner_;
};

}  // namespace

std::size_t firstOperand(const Instruction& operation) { return operation.opcode == Op::OpExtInst ? 2 : 0; }

const char* nameOf(ChainKind kind) {
  constexpr const char* kNames[] = {"sum", "product", "minimum", "maximum"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Chain> findChains(const Module& module, const Function& function) { return ChainFinder(module, function).run(); }

}  // namespace reprise

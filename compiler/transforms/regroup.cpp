#include "compiler/transforms/regroup.h"

namespace reprise {
namespace {

using spv::Op;

struct Root {
  Block* block = nullptr;
  std::size_t index = 0;
};

Root findRoot(Module& module, std::uint32_t function_id, std::uint32_t id) {
  Function* function = findFunction(module, function_id);
  REPRISE_CHECK(function != nullptr, function_id);
  for (Block& block : function->blocks)
    for (std::size_t i = 0; i < block.instructions.size(); ++i)
      if (block.instructions[i].result_id == id) return {&block, i};
  REPRISE_CHECK(false, id);
  return {};
}

// Joins values one after another with the operation of a chain's root.
class Joiner {
 public:
  Joiner(Module& module, const Instruction& root) : module_(module), root_(root) {}

  void start(std::uint32_t value) { result_ = value; }

  void add(const ChainTerm& term) {
    if (result_ == 0) {
      result_ = term.value;
      if (term.negative) append(makeInstruction(Op::OpFNegate, root_.type_id, 0, {idOperand(term.value)}));
      return;
    }
    Instruction joined = root_;
    const std::size_t first = firstOperand(root_);
    joined.operands[first] = idOperand(result_);
    joined.operands[first + 1] = idOperand(term.value);
    if (joined.opcode == Op::OpFAdd || joined.opcode == Op::OpFSub) joined.opcode = term.negative ? Op::OpFSub : Op::OpFAdd;
    append(std::move(joined));
  }

  // The last result under `id`; a single value gets there by a copy.
  std::vector<Instruction> finish(std::uint32_t id) {
    if (code_.empty()) append(makeInstruction(Op::OpCopyObject, root_.type_id, 0, {idOperand(result_)}));
    code_.back().result_id = id;
    return std::move(code_);
  }

 private:
  void append(Instruction instruction) {
    instruction.result_id = module_.freshId();
    instruction.line = root_.line;
    result_ = instruction.result_id;
    code_.push_back(std::move(instruction));
  }

  Module& module_;
  Instruction root_;
  std::uint32_t result_ = 0;
  std::vector<Instruction> code_;
};

void insert(const Root& at, const std::vector<Instruction>& code) {
  auto& instructions = at.block->instructions;
  instructions.insert(instructions.begin() + static_cast<std::ptrdiff_t>(at.index), code.begin(), code.end());
}

}  // namespace

Module addPartial(const Module& module, const RegroupPlace& place, const Regrouping& regrouping) {
  Module result = module;
  const Root root = findRoot(result, place.function, regrouping.chain.root);
  Joiner joiner(result, root.block->instructions[root.index]);
  for (std::size_t i = 0; i < regrouping.kept.size(); ++i)
    if (regrouping.kept[i]) joiner.add(regrouping.chain.terms[i]);
  insert(root, joiner.finish(place.partial));
  return result;
}

Module usePartial(const Module& module, const RegroupPlace& place, const Regrouping& regrouping) {
  Module result = module;
  const Root root = findRoot(result, place.function, regrouping.chain.root);
  Joiner joiner(result, root.block->instructions[root.index]);
  joiner.start(place.partial);
  for (std::size_t i = 0; i < regrouping.kept.size(); ++i)
    if (!regrouping.kept[i]) joiner.add(regrouping.chain.terms[i]);
  const std::vector<Instruction> code = joiner.finish(regrouping.chain.root);
  // The first computation stays behind as dead code.
  root.block->instructions[root.index].result_id = result.freshId();
  insert(root, code);
  return result;
}

}  // namespace reprise

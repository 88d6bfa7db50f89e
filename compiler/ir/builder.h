// Writes instructions one behind the other, with fresh ids.
//
//   Builder build(module, code, line);          // appends to `code`, a block's instructions or a piece of them
//   const uint32_t sum = build.result(Op::OpIAdd, int_type, {idOperand(a), idOperand(b)});
//   build.store(pointer, sum);
//
// Types and constants are found or added by globals.h. Nothing is folded: what is written is what was asked for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

class Builder {
 public:
  // `module` gives the ids; every instruction gets `line`. Both must outlive the builder.
  Builder(Module& module, std::vector<Instruction>& code, const LineMark& line = {}) : module_(module), code_(code), line_(line) {}

  // An instruction with a result; returns its id. With `id` the result has that one instead of a fresh one.
  std::uint32_t result(spv::Op opcode, std::uint32_t type_id, std::vector<Operand> operands, std::uint32_t id = 0);
  // One without.
  void effect(spv::Op opcode, std::vector<Operand> operands);

  std::uint32_t load(std::uint32_t type_id, std::uint32_t pointer, std::uint32_t id = 0);
  void store(std::uint32_t pointer, std::uint32_t value);
  // indices: literals, outermost first. Without indices the value itself, and no instruction.
  std::uint32_t extract(std::uint32_t type_id, std::uint32_t composite, std::span<const std::uint32_t> indices, std::uint32_t id = 0);
  // `composite` (of type type_id) with the part at `indices` replaced.
  std::uint32_t insert(std::uint32_t type_id, std::uint32_t part, std::uint32_t composite, std::span<const std::uint32_t> indices);
  std::uint32_t construct(std::uint32_t type_id, std::span<const std::uint32_t> parts, std::uint32_t id = 0);

  void branch(std::uint32_t label);
  void branchIf(std::uint32_t condition, std::uint32_t if_true, std::uint32_t if_false);
  void mergeAt(std::uint32_t label);  // OpSelectionMerge

 private:
  Module& module_;
  std::vector<Instruction>& code_;
  LineMark line_;
};

}  // namespace reprise

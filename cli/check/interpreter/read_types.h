// Types and decorations of a module, as they come.
#pragma once

#include <span>

#include "cli/check/interpreter/program.h"

namespace reprise::interpreter {

bool isDecoration(spv::Op op);
bool isType(spv::Op op);

class TypeReader {
 public:
  explicit TypeReader(Program& program) : program_(program) {}

  // OpDecorate, OpMemberDecorate, OpDecorateId, OpDecorationGroup, OpGroupDecorate, OpGroupMemberDecorate.
  Result<void> decorate(spv::Op op, std::uint32_t result, std::span<const std::uint32_t> operands);
  Result<void> define(spv::Op op, std::uint32_t result, std::span<const std::uint32_t> operands);
  Decorations decorationsOf(std::uint32_t id) const;

 private:
  Result<void> defineStruct(Type& type, std::uint32_t result, std::span<const std::uint32_t> members);
  // The type that operand `index` names; null if there is none.
  const Type* typeAt(std::span<const std::uint32_t> operands, std::size_t index, std::uint32_t& number) const;
  // A row of `count` elements.
  Result<void> makeRow(Type& type, std::span<const std::uint32_t> operands, std::uint64_t count);

  Program& program_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Decorations> decorations_;  // by id and member; kWhole: the id itself
};

}  // namespace reprise::interpreter

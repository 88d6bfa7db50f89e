// How a function's local variables are accessed: what has to be known before one of them is taken apart or becomes a value.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "compiler/ir/module.h"

namespace reprise {

// A pointer into a local variable, through any number of access chains and copies.
struct LocalPointer {
  std::uint32_t variable = 0;
  std::vector<std::uint32_t> indices;  // ids, outermost first; empty: the variable itself
};

class LocalAccess {
 public:
  LocalAccess(const Module& module, const Function& function);

  const std::unordered_map<std::uint32_t, LocalPointer>& pointers() const { return pointers_; }  // by id, variables too
  // Where a pointer leads; null if it is none into a local variable.
  const LocalPointer* find(std::uint32_t pointer) const;
  // Pointers that something else uses than loads and stores of the ordinary kind: calls, atomics, modf, copies of memory, volatile
  // accesses. By variable.
  const std::vector<LocalPointer>& escaping(std::uint32_t variable) const;
  // The value of an index if it is a constant that no specialization changes.
  std::optional<std::uint32_t> constantIndex(std::uint32_t id) const;

 private:
  void visit(const Instruction& instruction);

  std::unordered_map<std::uint32_t, LocalPointer> pointers_;
  std::unordered_map<std::uint32_t, std::vector<LocalPointer>> escaping_;
  std::unordered_map<std::uint32_t, std::uint32_t> constants_;
};

}  // namespace reprise

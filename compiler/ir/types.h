// The globals of a module by id, and what types are made of.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "compiler/ir/module.h"

namespace reprise {

class Types {
 public:
  explicit Types(const Module& module);  // which must outlive it, unchanged

  const Instruction* find(std::uint32_t id) const;  // null: no global
  std::uint32_t pointee(std::uint32_t pointer_type) const;
  // Of a struct or an array, how many parts it has; nothing for other types and for arrays whose length is not known.
  std::optional<std::uint32_t> parts(std::uint32_t type_id) const;
  std::uint32_t part(std::uint32_t type_id, std::uint32_t index) const;
  // The type of a part, of vectors and matrices too; 0 where there is none.
  std::uint32_t at(std::uint32_t type_id, std::uint32_t index) const;

 private:
  std::unordered_map<std::uint32_t, const Instruction*> globals_;
};

}  // namespace reprise

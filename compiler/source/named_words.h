// The names, types and interface variables of a module, read from its words, and the words with other names.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <utility>
#include <vector>

namespace reprise {

class NamedWords {
 public:
  struct Variable {
    std::uint32_t id = 0, type = 0;  // type: what the pointer points at, without arrays
    spv::StorageClass storage = spv::StorageClass::Max;
  };
  struct Type {
    spv::Op opcode = spv::Op::OpNop;
    std::vector<std::uint32_t> operands;  // behind the result
  };

  // A module that passed the validator, with one entry point.
  explicit NamedWords(std::span<const std::uint32_t> words);

  spv::ExecutionModel stage() const { return stage_; }
  const std::vector<Variable>& variables() const { return variables_; }  // global ones
  const Type* type(std::uint32_t id) const;
  std::uint32_t withoutArrays(std::uint32_t type) const;
  std::optional<std::uint32_t> decoration(std::uint32_t id, spv::Decoration decoration) const;
  std::optional<std::uint32_t> memberDecoration(std::uint32_t type, std::uint32_t member, spv::Decoration decoration) const;
  // The value of an integer constant; nullopt for anything else.
  std::optional<std::uint32_t> constant(std::uint32_t id) const;

  std::string name(std::uint32_t id) const;  // "" where there is none
  std::string memberName(std::uint32_t type, std::uint32_t member) const;
  void setName(std::uint32_t id, const std::string& name);  // "" takes a name away
  void setMemberName(std::uint32_t type, std::uint32_t member, const std::string& name);

  std::vector<std::uint32_t> take() const;

 private:
  using Member = std::pair<std::uint32_t, std::uint32_t>;
  void read(spv::Op opcode, std::span<const std::uint32_t> operands);

  std::span<const std::uint32_t> words_;
  spv::ExecutionModel stage_ = spv::ExecutionModel::Max;
  std::vector<Variable> variables_;
  std::map<std::uint32_t, Type> types_;
  std::map<std::uint32_t, std::uint32_t> constants_;
  std::map<std::pair<std::uint32_t, spv::Decoration>, std::uint32_t> decorations_;
  std::map<std::pair<Member, spv::Decoration>, std::uint32_t> member_decorations_;
  std::map<std::uint32_t, std::string> names_;
  std::map<Member, std::string> member_names_;
  bool changed_ = false;
};

}  // namespace reprise

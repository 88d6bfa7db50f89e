#include "compiler/ir/split_variables.h"

#include <algorithm>
#include <map>
#include <set>

#include "compiler/ir/builder.h"
#include "compiler/ir/globals.h"
#include "compiler/ir/live_names.h"
#include "compiler/ir/local_access.h"
#include "compiler/ir/types.h"

namespace reprise {
namespace {

using spv::Op;
using Path = std::vector<std::uint32_t>;  // literal indices, outermost first

bool beginsWith(const Path& path, const Path& prefix) {
  return path.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

struct Part {
  Path path;
  std::uint32_t type_id = 0;
  std::uint32_t variable = 0;
  std::uint32_t initial = 0;  // a constant; 0: none
};

// The parts of one variable.
class Splitting {
 public:
  // `closed`: paths below which nothing is taken apart.
  Splitting(const Types& types, std::uint32_t type_id, const std::set<Path>& closed) : types_(types), type_id_(type_id), closed_(closed) {
    split(type_id, {});
    if (parts_.size() > kMostSplitParts) parts_.clear();
  }

  std::uint32_t type() const { return type_id_; }
  std::vector<Part>& parts() { return parts_; }  // empty: the variable stays whole
  const std::vector<Part>& parts() const { return parts_; }

  // The part that a path leads to or into; null for an inner node.
  const Part* partAt(const Path& path) const {
    for (const Part& part : parts_)
      if (beginsWith(path, part.path)) return &part;
    return nullptr;
  }

 private:
  void split(std::uint32_t type_id, const Path& path) {
    if (parts_.size() > kMostSplitParts) return;
    const std::optional<std::uint32_t> count = types_.parts(type_id);
    if (!count || *count == 0 || *count > kMostSplitElements || closed_.count(path) != 0) {
      if (!path.empty()) parts_.push_back({path, type_id});
      return;
    }
    for (std::uint32_t i = 0; i < *count; ++i) {
      Path below = path;
      below.push_back(i);
      split(types_.part(type_id, i), below);
    }
  }

  const Types& types_;
  std::uint32_t type_id_;
  std::set<Path> closed_;
  std::vector<Part> parts_;
};

class Splitter {
 public:
  // The module given outlives the splitter; `types_` points into it.
  Splitter(const Module& module, std::uint32_t function_id)
      : module_(module), types_(module), function_(*findFunction(module_, function_id)), access_(module, *findFunction(module, function_id)) {}

  Module run() {
    findClosed();
    for (const Instruction& instruction : function_.blocks.front().instructions)
      if (instruction.opcode == Op::OpVariable) consider(instruction);
    if (splittings_.empty()) return std::move(module_);
    replaceVariables();
    for (Block& block : function_.blocks) {
      std::vector<Instruction> code;
      for (Instruction& instruction : block.instructions) rewrite(instruction, code);
      block.instructions = std::move(code);
    }
    dropNamesOfNothing(module_);
    return std::move(module_);
  }

 private:
  // What is indexed dynamically stays whole, and so does what escapes.
  void findClosed() {
    for (const Instruction& variable : function_.blocks.front().instructions)
      if (variable.opcode == Op::OpVariable) type_of_[variable.result_id] = types_.pointee(variable.type_id);
    for (const auto& [id, pointer] : access_.pointers()) {
      const Path prefix = constantPrefix(pointer);
      if (prefix.size() < pointer.indices.size()) closed_[pointer.variable].insert(prefix);
      if (id == pointer.variable)
        for (const LocalPointer& escaping : access_.escaping(id)) closed_[id].insert(constantPrefix(escaping));
    }
  }

  void consider(const Instruction& variable) {
    Splitting splitting(types_, type_of_.at(variable.result_id), closed_[variable.result_id]);
    if (splitting.parts().empty()) return;
    if (variable.operands.size() > 1)
      for (Part& part : splitting.parts())
        if (!findInitial(variable.word(1), part)) return;
    splittings_.emplace(variable.result_id, std::move(splitting));
  }

  // Its constant indices up to the first that is none, or that leaves its array.
  Path constantPrefix(const LocalPointer& pointer) const {
    std::uint32_t type_id = type_of_.at(pointer.variable);
    Path path;
    for (const std::uint32_t index : pointer.indices) {
      const std::optional<std::uint32_t> value = access_.constantIndex(index), count = types_.parts(type_id);
      if (!count || !value || *value >= *count) break;
      path.push_back(*value);
      type_id = types_.part(type_id, *value);
    }
    return path;
  }

  // The constant that a part begins with. False where the initializer is computed as a whole.
  bool findInitial(std::uint32_t constant_id, Part& part) {
    for (const std::uint32_t index : part.path) {
      const Instruction* constant = types_.find(constant_id);
      if (constant == nullptr) return false;
      if (constant->opcode == Op::OpUndef) return true;
      if (constant->opcode == Op::OpConstantNull) {
        part.initial = findOrAddGlobal(module_, Op::OpConstantNull, part.type_id, {});
        return true;
      }
      if (constant->opcode != Op::OpConstantComposite && constant->opcode != Op::OpSpecConstantComposite) return false;
      constant_id = constant->word(index);
    }
    part.initial = constant_id;
    return true;
  }

  void replaceVariables() {
    std::vector<Instruction>& entry = function_.blocks.front().instructions;
    std::vector<Instruction> variables;
    for (const Instruction& instruction : entry) {
      const auto splitting = instruction.opcode == Op::OpVariable ? splittings_.find(instruction.result_id) : splittings_.end();
      if (splitting == splittings_.end()) continue;
      for (Part& part : splitting->second.parts()) {
        const std::uint32_t pointer = pointerType(module_, spv::StorageClass::Function, part.type_id);
        part.variable = module_.freshId();
        variables.push_back(makeInstruction(Op::OpVariable, pointer, part.variable,
                                            {literalOperand(static_cast<std::uint32_t>(spv::StorageClass::Function))}));
        variables.back().line = instruction.line;
        if (part.initial != 0) variables.back().operands.push_back(idOperand(part.initial));
      }
    }
    copyDecorations();
    entry.insert(entry.begin(), variables.begin(), variables.end());
  }

  // RelaxedPrecision of the whole is that of its parts.
  void copyDecorations() {
    const std::size_t count = module_.annotations.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (module_.annotations[i].opcode != Op::OpDecorate) continue;
      const auto splitting = splittings_.find(module_.annotations[i].word(0));
      if (splitting == splittings_.end()) continue;
      for (const Part& part : splitting->second.parts()) {
        Instruction copy = module_.annotations[i];
        copy.operands[0] = idOperand(part.variable);
        module_.annotations.push_back(std::move(copy));
      }
    }
  }

  const Splitting* splittingOf(std::uint32_t pointer) const {
    const LocalPointer* local = access_.find(pointer);
    const auto found = local == nullptr ? splittings_.end() : splittings_.find(local->variable);
    return found == splittings_.end() ? nullptr : &found->second;
  }

  Path pathOf(std::uint32_t pointer) const { return constantPrefix(*access_.find(pointer)); }

  void rewrite(Instruction& instruction, std::vector<Instruction>& code) {
    if (instruction.opcode == Op::OpVariable) {
      if (splittings_.count(instruction.result_id) == 0) code.push_back(std::move(instruction));
      return;
    }
    if (instruction.result_id != 0 && splittingOf(instruction.result_id) != nullptr) return rewritePointer(instruction, code);
    const bool moves = instruction.opcode == Op::OpLoad || instruction.opcode == Op::OpStore;
    if (moves && splittingOf(instruction.word(0)) != nullptr) {
      const Splitting& splitting = *splittingOf(instruction.word(0));
      const Path path = pathOf(instruction.word(0));
      if (splitting.partAt(path) == nullptr) return moveParts(instruction, splitting, code, path);
    }
    for (Operand& operand : instruction.operands)
      if (operand.is_id)
        if (const auto replaced = replaced_.find(operand.words[0]); replaced != replaced_.end()) operand.words[0] = replaced->second;
    code.push_back(std::move(instruction));
  }

  // A chain to a part is the part's variable; one into a part goes on from there; one to an inner node is not needed.
  void rewritePointer(Instruction& instruction, std::vector<Instruction>& code) {
    const LocalPointer& pointer = *access_.find(instruction.result_id);
    const Part* part = splittingOf(instruction.result_id)->partAt(pathOf(instruction.result_id));
    if (part == nullptr) return;
    if (pointer.indices.size() == part->path.size()) {
      replaced_[instruction.result_id] = part->variable;
      return;
    }
    instruction.opcode = Op::OpAccessChain;
    instruction.operands = {idOperand(part->variable)};
    for (std::size_t i = part->path.size(); i < pointer.indices.size(); ++i) instruction.operands.push_back(idOperand(pointer.indices[i]));
    code.push_back(std::move(instruction));
  }

  void moveParts(const Instruction& instruction, const Splitting& splitting, std::vector<Instruction>& code, const Path& path) {
    Builder build(module_, code, instruction.line);
    if (instruction.opcode == Op::OpLoad) {
      loadNode(build, splitting, {path, instruction.type_id}, instruction.result_id);
      return;
    }
    for (const Part& part : splitting.parts()) {
      if (!beginsWith(part.path, path)) continue;
      const Path relative(part.path.begin() + static_cast<std::ptrdiff_t>(path.size()), part.path.end());
      build.store(part.variable, build.extract(part.type_id, instruction.word(1), relative));
    }
  }

  struct NodeOfType {
    Path path;
    std::uint32_t type_id = 0;
  };

  std::uint32_t loadNode(Builder& build, const Splitting& splitting, const NodeOfType& node, std::uint32_t id) {
    if (const Part* part = splitting.partAt(node.path)) return build.load(node.type_id, part->variable, id);
    std::vector<std::uint32_t> parts;
    for (std::uint32_t i = 0; i < *types_.parts(node.type_id); ++i) {
      NodeOfType below{node.path, types_.part(node.type_id, i)};
      below.path.push_back(i);
      parts.push_back(loadNode(build, splitting, below, 0));
    }
    return build.construct(node.type_id, parts, id);
  }

  Module module_;
  const Types types_;
  Function& function_;
  const LocalAccess access_;
  std::map<std::uint32_t, std::uint32_t> type_of_;   // of each variable
  std::map<std::uint32_t, std::set<Path>> closed_;   // by variable
  std::map<std::uint32_t, Splitting> splittings_;    // by variable
  std::map<std::uint32_t, std::uint32_t> replaced_;  // pointer -> a part's variable
};

}  // namespace

Module splitVariables(const Module& module, std::uint32_t function) { return Splitter(module, function).run(); }

}  // namespace reprise

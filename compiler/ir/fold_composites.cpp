#include "compiler/ir/fold_composites.h"

#include <unordered_map>

#include "compiler/ir/substitute_ids.h"
#include "compiler/ir/types.h"

namespace reprise {
namespace {

using spv::Op;

class Folder {
 public:
  Folder(const Module& module, const Function& function) : types_(module) {
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (instruction.result_id != 0) definition_[instruction.result_id] = &instruction;
  }

  // What an extraction takes: a value and the indices that are left into it.
  struct Taken {
    std::uint32_t value = 0;
    std::vector<std::uint32_t> indices;
  };

  Taken follow(const Instruction& extract) const {
    Taken taken{extract.word(0), {}};
    for (std::size_t i = 1; i < extract.operands.size(); ++i) taken.indices.push_back(extract.word(i));
    while (!taken.indices.empty() && step(taken)) {
    }
    return taken;
  }

 private:
  bool step(Taken& taken) const {
    const Instruction* found = definitionOf(taken.value);
    // Copies carry names, so that one is looked through only if there is something behind it.
    while (found != nullptr && found->opcode == Op::OpCopyObject) found = definitionOf(found->word(0));
    if (found == nullptr) return false;
    const Instruction& made = *found;
    const Instruction* type = types_.find(made.type_id);
    if (type == nullptr || type->opcode == Op::OpTypeVector) return false;
    if (made.opcode == Op::OpCompositeConstruct) {
      if (taken.indices.front() >= made.operands.size()) return false;
      taken.value = made.word(taken.indices.front());
      taken.indices.erase(taken.indices.begin());
      return true;
    }
    if (made.opcode == Op::OpCompositeInsert) return through(made, taken);
    if (made.opcode != Op::OpCompositeExtract) return false;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 1; i < made.operands.size(); ++i) indices.push_back(made.word(i));
    taken.value = made.word(0);
    taken.indices.insert(taken.indices.begin(), indices.begin(), indices.end());
    return true;
  }

  const Instruction* definitionOf(std::uint32_t id) const {
    const auto found = definition_.find(id);
    return found == definition_.end() ? nullptr : found->second;
  }

  static bool through(const Instruction& insert, Taken& taken) {
    const std::size_t depth = insert.operands.size() - 2;
    std::size_t same = 0;
    while (same < depth && same < taken.indices.size() && insert.word(same + 2) == taken.indices[same]) ++same;
    if (same == depth) {
      taken.value = insert.word(0);
      taken.indices.erase(taken.indices.begin(), taken.indices.begin() + static_cast<std::ptrdiff_t>(depth));
      return true;
    }
    if (same == taken.indices.size()) return false;  // what is taken holds what was inserted
    taken.value = insert.word(1);
    return true;
  }

  const Types types_;
  std::unordered_map<std::uint32_t, const Instruction*> definition_;
};

}  // namespace

Module foldComposites(const Module& module, std::uint32_t function_id) {
  Module result = module;
  const Function& original = *findFunction(module, function_id);
  const Folder folder(module, original);
  std::unordered_map<std::uint32_t, std::uint32_t> replaced;
  Function& function = *findFunction(result, function_id);
  for (Block& block : function.blocks)
    for (Instruction& instruction : block.instructions) {
      if (instruction.opcode != Op::OpCompositeExtract) continue;
      const Folder::Taken taken = folder.follow(instruction);
      if (taken.indices.empty()) {
        replaced[instruction.result_id] = taken.value;
        continue;
      }
      instruction.operands = {idOperand(taken.value)};
      for (const std::uint32_t index : taken.indices) instruction.operands.push_back(literalOperand(index));
    }
  substituteIds(function, replaced);
  return result;
}

}  // namespace reprise

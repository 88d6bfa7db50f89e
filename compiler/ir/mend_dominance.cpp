#include "compiler/ir/mend_dominance.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>

#include "compiler/ir/builder.h"
#include "compiler/ir/control_flow.h"
#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

bool fitsVariable(const Module& module, std::uint32_t type_id) {
  const Instruction* type = findGlobal(module, type_id);
  switch (type->opcode) {
    case Op::OpTypePointer:
    case Op::OpTypeImage:
    case Op::OpTypeSampler:
    case Op::OpTypeSampledImage: return false;
    default: return true;
  }
}

class Mender {
 public:
  Mender(Module& module, Function& function) : module_(module), function_(function), flow_(analyseControlFlow(function)) {
    for (std::size_t block = 0; block < function.blocks.size(); ++block)
      for (std::size_t i = 0; i < blockAt(block).size(); ++i)
        if (const std::uint32_t id = blockAt(block)[i].result_id; id != 0) defined_[id] = {block, i};
  }

  // Whether anything was mended: what is computed again may use what has to be mended next.
  bool run() {
    for (std::size_t block = 0; block < function_.blocks.size(); ++block)
      for (std::size_t i = 0; flow_.reachable[block] && i < blockAt(block).size(); ++i) mendUses({block, i});
    const bool mended = !inserted_.empty();
    // From behind, so that places stay where they are.
    for (auto place = inserted_.rbegin(); place != inserted_.rend(); ++place) {
      std::vector<Instruction>& code = blockAt(place->first.block);
      code.insert(code.begin() + static_cast<std::ptrdiff_t>(place->first.index), place->second.begin(), place->second.end());
    }
    blockAt(0).insert(blockAt(0).begin(), variables_.begin(), variables_.end());
    return mended;
  }

 private:
  struct Place {
    std::size_t block = 0, index = 0;
    auto operator<=>(const Place&) const = default;
  };

  std::vector<Instruction>& blockAt(std::size_t block) { return function_.blocks[block].instructions; }

  void mendUses(const Place& at) {
    Instruction& user = blockAt(at.block)[at.index];
    const bool phi = user.opcode == Op::OpPhi;
    for (std::size_t i = 0; i < user.operands.size(); i += phi ? 2 : 1) {
      if (!user.operands[i].is_id) continue;
      const std::size_t block = phi ? static_cast<std::size_t>(flow_.block_of_label.at(user.word(i + 1))) : at.block;
      const auto definition = defined_.find(user.word(i));
      if (definition == defined_.end() || !flow_.reachable[block]) continue;
      if (dominates(flow_, static_cast<int>(definition->second.block), static_cast<int>(block))) continue;
      const Place before = beforeMerge(phi ? Place{block, blockAt(block).size() - 1} : at);
      user.operands[i] = idOperand(valueAt(before, definition->second));
    }
  }

  // Nothing may stand between a merge instruction and its branch.
  Place beforeMerge(Place place) {
    const std::vector<Instruction>& code = blockAt(place.block);
    if (place.index + 1 == code.size() && place.index > 0) {
      const Op before = code[place.index - 1].opcode;
      if (before == Op::OpLoopMerge || before == Op::OpSelectionMerge) --place.index;
    }
    return place;
  }

  std::uint32_t valueAt(const Place& place, const Place& definition) {
    const Instruction computed = blockAt(definition.block)[definition.index];
    if (!fitsVariable(module_, computed.type_id)) {
      Instruction again = computed;
      again.result_id = module_.freshId();
      inserted_[place].push_back(again);
      return again.result_id;
    }
    auto variable = variable_of_.find(computed.result_id);
    if (variable == variable_of_.end()) variable = variable_of_.emplace(computed.result_id, keep(computed, definition)).first;
    Builder build(module_, inserted_[place], computed.line);
    return build.load(computed.type_id, variable->second);
  }

  std::uint32_t keep(const Instruction& computed, const Place& definition) {
    const std::uint32_t pointer = pointerType(module_, spv::StorageClass::Function, computed.type_id), id = module_.freshId();
    variables_.push_back(
        makeInstruction(Op::OpVariable, pointer, id, {literalOperand(static_cast<std::uint32_t>(spv::StorageClass::Function))}));
    Place behind{definition.block, definition.index + 1};
    while (blockAt(behind.block)[behind.index].opcode == Op::OpPhi) ++behind.index;
    Builder build(module_, inserted_[behind], computed.line);
    build.store(id, computed.result_id);
    return id;
  }

  Module& module_;
  Function& function_;
  const ControlFlow flow_;
  std::unordered_map<std::uint32_t, Place> defined_;             // by id
  std::unordered_map<std::uint32_t, std::uint32_t> variable_of_;  // by id
  std::vector<Instruction> variables_;
  std::map<Place, std::vector<Instruction>> inserted_;           // before the instruction at a place
};

}  // namespace

void mendDominance(Module& module, Function& function) {
  while (Mender(module, function).run()) {
  }
}

}  // namespace reprise

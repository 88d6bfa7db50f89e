#include "compiler/ir/constructs.h"

#include <algorithm>

namespace reprise {
namespace {

using spv::Op;

std::vector<Construct> findConstructs(const Function& function, const ControlFlow& flow) {
  std::vector<Construct> found;
  for (std::size_t block = 0; block < function.blocks.size(); ++block)
    for (const Instruction& instruction : function.blocks[block].instructions) {
      const bool loop = instruction.opcode == Op::OpLoopMerge;
      if (!loop && instruction.opcode != Op::OpSelectionMerge) continue;
      Construct construct;
      construct.kind = loop                                                              ? ConstructKind::kLoop
                       : function.blocks[block].terminator().opcode == Op::OpSwitch ? ConstructKind::kSwitch
                                                                                    : ConstructKind::kSelection;
      construct.header = static_cast<int>(block);
      construct.merge = flow.block_of_label.at(instruction.word(0));
      if (loop) construct.continue_target = flow.block_of_label.at(instruction.word(1));
      found.push_back(construct);
    }
  return found;
}

}  // namespace

Constructs::Constructs(const Function& function, const ControlFlow& flow) : all_(findConstructs(function, flow)) {
  Edges successors = flow.successors, predecessors = flow.predecessors;
  const auto connect = [&](int from, int to) {
    std::vector<int>& out = successors[static_cast<std::size_t>(from)];
    if (to == kNoBlock || std::find(out.begin(), out.end(), to) != out.end()) return;
    out.push_back(to);
    predecessors[static_cast<std::size_t>(to)].push_back(from);
  };
  for (const Construct& construct : all_) {
    connect(construct.header, construct.merge);
    connect(construct.header, construct.continue_target);
  }
  immediate_dominator_ = immediateDominators(successors, predecessors);
}

bool Constructs::dominates(int dominator, int block) const {
  while (block != kNoBlock && block != dominator) block = immediate_dominator_[static_cast<std::size_t>(block)];
  return block == dominator;
}

bool Constructs::contains(const Construct& construct, int block) const {
  return dominates(construct.header, block) && !dominates(construct.merge, block);
}

bool Constructs::continues(const Construct& loop, int block) const {
  return loop.continue_target != kNoBlock && loop.continue_target != loop.header && contains(loop, block) &&
         dominates(loop.continue_target, block);
}

const Construct* Constructs::breakable(int block) const {
  const Construct* innermost = nullptr;
  for (const Construct& construct : all_) {
    if (construct.kind == ConstructKind::kSelection || construct.header == block || !contains(construct, block)) continue;
    if (innermost == nullptr || dominates(innermost->header, construct.header)) innermost = &construct;
  }
  return innermost;
}

}  // namespace reprise

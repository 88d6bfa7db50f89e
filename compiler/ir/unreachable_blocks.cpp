#include "compiler/ir/unreachable_blocks.h"

#include <unordered_map>
#include <unordered_set>

#include "compiler/ir/control_flow.h"
#include "compiler/ir/globals.h"

namespace reprise {
namespace {

using spv::Op;

struct KeptEmpty {
  std::unordered_set<std::uint32_t> merges;                            // labels
  std::unordered_map<std::uint32_t, std::uint32_t> header_of_continue;  // by label
};

KeptEmpty statedTargets(const Function& function, const ControlFlow& flow) {
  KeptEmpty kept;
  for (std::size_t block = 0; block < function.blocks.size(); ++block) {
    if (!flow.reachable[block]) continue;
    for (const Instruction& instruction : function.blocks[block].instructions) {
      if (instruction.opcode == Op::OpSelectionMerge || instruction.opcode == Op::OpLoopMerge) kept.merges.insert(instruction.word(0));
      if (instruction.opcode == Op::OpLoopMerge) kept.header_of_continue[instruction.word(1)] = function.blocks[block].label;
    }
  }
  return kept;
}

bool leadsToReachable(const Block& block, const ControlFlow& flow) {
  if (block.terminator().opcode != Op::OpBranch) return false;
  return flow.reachable[static_cast<std::size_t>(flow.block_of_label.at(block.terminator().word(0)))];
}

// A phi keeps an operand for each predecessor that is left, undefined from those that are never run.
void mendPhi(Module& module, Instruction& phi, const std::unordered_set<std::uint32_t>& gone,
             const std::unordered_set<std::uint32_t>& emptied) {
  std::vector<Operand> operands;
  for (std::size_t i = 0; i + 1 < phi.operands.size(); i += 2) {
    if (gone.count(phi.word(i + 1)) != 0) continue;
    operands.push_back(emptied.count(phi.word(i + 1)) != 0 ? idOperand(undefinedValue(module, phi.type_id)) : phi.operands[i]);
    operands.push_back(phi.operands[i + 1]);
  }
  phi.operands = std::move(operands);
}

// An emptied continue target is a new way into its header.
void addOperand(Module& module, Instruction& phi, std::uint32_t from) {
  for (std::size_t i = 1; i < phi.operands.size(); i += 2)
    if (phi.word(i) == from) return;
  phi.operands.push_back(idOperand(undefinedValue(module, phi.type_id)));
  phi.operands.push_back(idOperand(from));
}

}  // namespace

std::uint32_t undefinedValue(Module& module, std::uint32_t type_id) { return findOrAddGlobal(module, Op::OpUndef, type_id, {}); }

void removeUnreachableBlocks(Module& module, Function& function) {
  const ControlFlow flow = analyseControlFlow(function);
  const KeptEmpty kept = statedTargets(function, flow);
  std::unordered_set<std::uint32_t> gone, emptied;
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < function.blocks.size(); ++i) {
    Block& block = function.blocks[i];
    if (flow.reachable[i]) {
      blocks.push_back(std::move(block));
      continue;
    }
    const auto header = kept.header_of_continue.find(block.label);
    if (header != kept.header_of_continue.end()) {
      emptied.insert(block.label);
      blocks.push_back({block.label, {makeInstruction(Op::OpBranch, 0, 0, {idOperand(header->second)})}});
    } else if (kept.merges.count(block.label) != 0 && leadsToReachable(block, flow)) {
      // The way out stays: within a continue construct none but the back edge may be the end.
      emptied.insert(block.label);
      blocks.push_back({block.label, {block.terminator()}});
    } else if (kept.merges.count(block.label) != 0) {
      gone.insert(block.label);
      blocks.push_back({block.label, {makeInstruction(Op::OpUnreachable, 0, 0, {})}});
    } else {
      gone.insert(block.label);
    }
  }
  function.blocks = std::move(blocks);
  if (gone.empty() && emptied.empty()) return;
  std::unordered_map<std::uint32_t, std::uint32_t> continue_of_header;
  for (const std::uint32_t label : emptied)
    if (const auto header = kept.header_of_continue.find(label); header != kept.header_of_continue.end()) continue_of_header[header->second] = label;
  for (Block& block : function.blocks)
    for (Instruction& instruction : block.instructions) {
      if (instruction.opcode != Op::OpPhi) continue;
      mendPhi(module, instruction, gone, emptied);
      if (const auto added = continue_of_header.find(block.label); added != continue_of_header.end()) addOperand(module, instruction, added->second);
    }
}

}  // namespace reprise

#include "compiler/ir/inline_calls.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

#include "compiler/ir/builder.h"
#include "compiler/ir/constructs.h"
#include "compiler/ir/control_flow.h"
#include "compiler/ir/live_names.h"
#include "compiler/ir/private_variables.h"
#include "compiler/ir/single_return.h"
#include "compiler/ir/substitute_ids.h"
#include "compiler/ir/unreachable_blocks.h"
#include "compiler/source/module_limits.h"

namespace reprise {
namespace {

using spv::Op;
using Ids = std::unordered_map<std::uint32_t, std::uint32_t>;

// Of ids that get copies: their names and decorations, to be copied too.
class NamesAndDecorations {
 public:
  explicit NamesAndDecorations(const Module& module) {
    learn(module.names, 0);
    learn(module.annotations, 0);
  }

  // What a section has from `first` on.
  void learn(const std::vector<Instruction>& section, std::size_t first) {
    for (std::size_t i = first; i < section.size(); ++i)
      if (section[i].opcode == Op::OpName || section[i].opcode == Op::OpDecorate || section[i].opcode == Op::OpDecorateId)
        about_[section[i].word(0)].push_back(section[i]);
  }

  void copy(Module& module, std::uint32_t from, std::uint32_t to) {
    const auto found = about_.find(from);
    if (found == about_.end()) return;
    const std::vector<Instruction> originals = found->second;  // the table grows below
    for (Instruction about : originals) {
      about.operands[0] = idOperand(to);
      (about.opcode == Op::OpName ? module.names : module.annotations).push_back(about);
      about_[to].push_back(std::move(about));
    }
  }

 private:
  std::unordered_map<std::uint32_t, std::vector<Instruction>> about_;  // by target
};

struct Callee {
  Function function;
  bool can_be_inlined = false;
};

bool isMerge(const Instruction& instruction) {
  return instruction.opcode == Op::OpLoopMerge || instruction.opcode == Op::OpSelectionMerge;
}

void renamePredecessor(Function& function, std::uint32_t from, std::uint32_t to, const std::vector<std::uint32_t>& successors) {
  for (Block& block : function.blocks) {
    if (std::find(successors.begin(), successors.end(), block.label) == successors.end()) continue;
    for (Instruction& phi : block.instructions)
      if (phi.opcode == Op::OpPhi)
        for (std::size_t i = 1; i < phi.operands.size(); i += 2)
          if (phi.word(i) == from) phi.operands[i] = idOperand(to);
  }
}

class Inliner {
 public:
  explicit Inliner(const Module& module) : module_(module), about_(module) {}

  Module run() {
    std::vector<Function> entries;
    for (const Instruction& entry : module_.entry_points) {
      const Function* function = findFunction(module_, entry.word(1));
      REPRISE_CHECK(function != nullptr, entry.word(1));
      const bool again = std::any_of(entries.begin(), entries.end(), [&](const Function& one) { return one.id() == function->id(); });
      if (!again) entries.push_back(flattened(*function));
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) entries.push_back(callees_.at(kept_[i]).function);
    module_.functions = std::move(entries);
    dropNamesOfNothing(module_);
    return std::move(module_);
  }

 private:
  // A function whose own calls are inlined.
  Function flattened(const Function& original) {
    Function function = original;
    if (function.blocks.empty()) return function;
    removeUnreachableBlocks(module_, function);
    open_.insert(function.id());
    // Blocks that a call brings in hold no calls but those that stay.
    for (std::size_t block = 0; block < function.blocks.size();) block = inlineFirst(function, block);
    open_.erase(function.id());
    substituteIds(function, value_of_call_);
    removeUnreachableBlocks(module_, function);
    return function;
  }

  const Callee& callee(std::uint32_t id) {
    if (const auto known = callees_.find(id); known != callees_.end()) return known->second;
    const Function* original = findFunction(module_, id);
    REPRISE_CHECK(original != nullptr, id);
    Callee made{*original, false};
    if (!original->blocks.empty() && open_.count(id) == 0) {
      made.function = flattened(*original);
      const std::size_t names = module_.names.size();
      if (auto single = withSingleReturn(module_, made.function)) {
        about_.learn(module_.names, names);
        made.function = std::move(*single);
        made.can_be_inlined = true;
      }
    }
    return callees_[id] = std::move(made);
  }

  // Replaces the first call of a block that can be; returns the block to go on with.
  std::size_t inlineFirst(Function& function, std::size_t block) {
    const auto next = settled_.find(function.blocks[block].label);
    std::size_t start = next == settled_.end() ? 0 : next->second;
    for (std::size_t i = start; i < function.blocks[block].instructions.size(); ++i) {
      const Instruction& call = function.blocks[block].instructions[i];
      if (call.opcode != Op::OpFunctionCall) continue;
      const std::uint32_t called = call.word(0);
      if (callee(called).can_be_inlined && placeBody(function, block, i)) return block;
      if (std::find(kept_.begin(), kept_.end(), called) == kept_.end()) kept_.push_back(called);
    }
    return block + 1;
  }

  // The callee's blocks with ids of their own, its parameters replaced by the arguments.
  std::vector<Block> copyOf(const Function& function, const Instruction& call) {
    Ids ids;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) ids[function.parameters[i].result_id] = call.word(i + 1);
    const auto renew = [&](std::uint32_t id) {
      const std::uint32_t fresh = module_.freshId();
      ids[id] = fresh;
      about_.copy(module_, id, fresh);
    };
    for (const Block& block : function.blocks) {
      renew(block.label);
      for (const Instruction& instruction : block.instructions)
        if (instruction.result_id != 0) renew(instruction.result_id);
    }
    const auto translate = [&](std::uint32_t& id) {
      if (const auto found = ids.find(id); found != ids.end()) id = found->second;
    };
    std::vector<Block> blocks = function.blocks;
    for (Block& block : blocks) {
      translate(block.label);
      for (Instruction& instruction : block.instructions) {
        translate(instruction.result_id);
        for (Operand& operand : instruction.operands)
          if (operand.is_id) translate(operand.words[0]);
      }
    }
    return blocks;
  }

  // Locals go to the caller's entry block; returned are the stores of their initializers.
  std::vector<Instruction> moveVariables(Function& function, Block& first) {
    std::vector<Instruction> moved, stores;
    Builder build(module_, stores);
    while (!first.instructions.empty() && first.instructions.front().opcode == Op::OpVariable) {
      Instruction variable = std::move(first.instructions.front());
      first.instructions.erase(first.instructions.begin());
      if (variable.operands.size() > 1) build.store(variable.result_id, variable.word(1));
      variable.operands.resize(1);
      moved.push_back(std::move(variable));
    }
    std::vector<Instruction>& entry = function.blocks.front().instructions;
    entry.insert(entry.begin(), std::make_move_iterator(moved.begin()), std::make_move_iterator(moved.end()));
    return stores;
  }

  // A continue construct is left by its back edge alone: nothing may end the invocation in it.
  static bool endsWhereItMayNot(const Function& body, const Function& caller, std::size_t index) {
    const bool ends = std::any_of(body.blocks.begin(), body.blocks.end(), [](const Block& block) {
      const Op last = block.terminator().opcode;
      return last == Op::OpKill || last == Op::OpTerminateInvocation || last == Op::OpUnreachable;
    });
    if (!ends) return false;
    const ControlFlow flow = analyseControlFlow(caller);
    const Constructs constructs(caller, flow);
    return std::any_of(constructs.all().begin(), constructs.all().end(),
                       [&](const Construct& loop) { return constructs.continues(loop, static_cast<int>(index)); });
  }

  bool placeBody(Function& function, std::size_t index, std::size_t at) {
    const Function& body = callee(function.blocks[index].instructions[at].word(0)).function;
    if (endsWhereItMayNot(body, function, index)) return false;
    const bool one_block = body.blocks.size() == 1;
    const bool in_loop_header = std::any_of(function.blocks[index].instructions.begin(), function.blocks[index].instructions.end(),
                                            [](const Instruction& one) { return one.opcode == Op::OpLoopMerge; });
    if (!one_block && in_loop_header) {
      // The header ends before the call; what follows becomes a block of the loop.
      if (!splitHeader(function, index, at)) return false;
      return true;
    }
    const Instruction call = function.blocks[index].instructions[at];
    std::vector<Block> blocks = copyOf(body, call);
    const std::size_t variables = countVariables(blocks.front());
    std::vector<Instruction> code = moveVariables(function, blocks.front());
    if (index == 0) at += variables;
    Block& caller = function.blocks[index];
    const auto after = caller.instructions.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    std::vector<Instruction> rest(std::make_move_iterator(after), std::make_move_iterator(caller.instructions.end()));
    caller.instructions.resize(at);
    const std::uint32_t first_label = blocks.front().label;
    caller.instructions.insert(caller.instructions.end(), code.begin(), code.end());
    std::vector<Instruction>& first = blocks.front().instructions;
    caller.instructions.insert(caller.instructions.end(), std::make_move_iterator(first.begin()), std::make_move_iterator(first.end()));
    for (Block& block : blocks)
      for (Instruction& instruction : block.instructions)
        for (Operand& operand : instruction.operands)
          if (operand.is_id && operand.words[0] == first_label) operand.words[0] = caller.label;
    finish(function, index, {std::move(blocks), std::move(rest), call});
    return true;
  }

  static std::size_t countVariables(const Block& block) {
    return static_cast<std::size_t>(std::count_if(block.instructions.begin(), block.instructions.end(),
                                                  [](const Instruction& one) { return one.opcode == Op::OpVariable; }));
  }

  struct Placed {
    std::vector<Block> blocks;      // of the body; the first one's code is at the end of the caller's block
    std::vector<Instruction> rest;  // of the caller's block, after the call
    Instruction call;
  };

  // The rest of the caller's block follows the return.
  void finish(Function& function, std::size_t index, Placed placed) {
    std::vector<Block>& blocks = placed.blocks;
    Block& last = blocks.size() == 1 ? function.blocks[index] : blocks.back();
    const std::uint32_t caller_label = function.blocks[index].label;
    const std::vector<std::uint32_t> successors = targetsOf(placed.rest.back());
    const Instruction ending = last.instructions.back();
    std::uint32_t value = 0, rest_label = last.label;
    if (ending.opcode == Op::OpReturn || ending.opcode == Op::OpReturnValue) {
      last.instructions.pop_back();
      if (ending.opcode == Op::OpReturnValue) value = ending.word(0);
      settle(placed.call, value);
      settled_[last.label] = last.instructions.size();
      last.instructions.insert(last.instructions.end(), std::make_move_iterator(placed.rest.begin()), std::make_move_iterator(placed.rest.end()));
    } else {
      // It never returns: nothing leads to the rest.
      rest_label = module_.freshId();
      settle(placed.call, 0);
      blocks.push_back({rest_label, std::move(placed.rest)});
    }
    function.blocks.insert(function.blocks.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::make_move_iterator(blocks.begin() + 1),
                           std::make_move_iterator(blocks.end()));
    if (rest_label != caller_label) renamePredecessor(function, caller_label, rest_label, successors);
  }

  void settle(const Instruction& call, std::uint32_t value) {
    if (findGlobalOpcode(call.type_id) == Op::OpTypeVoid) return;
    value_of_call_[call.result_id] = value != 0 ? value : undefinedValue(module_, call.type_id);
  }

  Op findGlobalOpcode(std::uint32_t type_id) {
    const Instruction* type = findGlobal(module_, type_id);
    REPRISE_CHECK(type != nullptr, type_id);
    return type->opcode;
  }

  // A loop header ends with its merge instruction: what stands from `at` on goes into a block behind it. A loop of one block gets a
  // continue block of its own. False where the header branches two ways into the loop, which would need a selection of its own.
  bool splitHeader(Function& function, std::size_t index, std::size_t at) {
    const Block& header = function.blocks[index];
    const auto stated = std::find_if(header.instructions.begin(), header.instructions.end(), isMerge);
    const std::uint32_t merge = stated->word(0), next = stated->word(1);
    const Instruction& branch = header.terminator();
    if (branch.opcode == Op::OpSwitch) return false;
    if (branch.opcode == Op::OpBranchConditional) {
      const auto leaves = [&](std::uint32_t target) { return target == merge || target == next || target == header.label; };
      if (!leaves(branch.word(1)) && !leaves(branch.word(2))) return false;
    }
    const std::vector<std::uint32_t> successors = targetsOf(branch);
    Instruction loop_merge = *stated;
    Block body{module_.freshId(), {}};
    body.instructions.assign(header.instructions.begin() + static_cast<std::ptrdiff_t>(at), header.instructions.end());
    std::erase_if(body.instructions, isMerge);
    Block& begin = function.blocks[index];
    begin.instructions.resize(at);
    std::vector<Block> added;
    std::uint32_t back = begin.label;
    if (next == begin.label) {
      added.push_back({module_.freshId(), {makeInstruction(Op::OpBranch, 0, 0, {idOperand(begin.label)})}});
      back = added.front().label;
      loop_merge.operands[1] = idOperand(back);
      for (Operand& operand : body.instructions.back().operands)
        if (operand.is_id && operand.words[0] == begin.label) operand.words[0] = back;
    }
    begin.instructions.push_back(loop_merge);
    Builder(module_, begin.instructions, loop_merge.line).branch(body.label);
    const std::uint32_t header_label = begin.label, body_label = body.label;
    added.insert(added.begin(), std::move(body));
    function.blocks.insert(function.blocks.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::make_move_iterator(added.begin()),
                           std::make_move_iterator(added.end()));
    renamePredecessor(function, header_label, body_label, successors);
    if (back != header_label) renamePredecessor(function, body_label, back, {header_label});
    return true;
  }

  Module module_;
  NamesAndDecorations about_;
  std::unordered_map<std::uint32_t, Callee> callees_;   // by id
  std::unordered_set<std::uint32_t> open_;              // functions that are being flattened
  std::unordered_map<std::uint32_t, std::size_t> settled_;  // by label: instructions at its start that need no second look
  std::unordered_map<std::uint32_t, std::uint32_t> value_of_call_;
  std::vector<std::uint32_t> kept_;                     // functions of calls that stay
};

}  // namespace

Result<Module> inlineCalls(const Module& module) {
  const Module inlined = privatesToLocals(Inliner(module).run());
  if (const Result<void> small = checkModuleLimits(writeModule(inlined)); !small.ok())
    return Error{ErrorKind::kRefused, "shader.limit", "with all calls inlined " + small.error().message, {}};
  return inlined;
}

}  // namespace reprise

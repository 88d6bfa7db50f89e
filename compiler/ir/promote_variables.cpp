#include "compiler/ir/promote_variables.h"

#include <algorithm>
#include <unordered_map>

#include "compiler/ir/builder.h"
#include "compiler/ir/control_flow.h"
#include "compiler/ir/live_names.h"
#include "compiler/ir/local_access.h"
#include "compiler/ir/substitute_ids.h"
#include "compiler/ir/types.h"
#include "compiler/ir/unreachable_blocks.h"

namespace reprise {
namespace {

using spv::Op;

// Blocks whose dominance frontier each block is in, as lists by block: Cooper, Harvey, Kennedy (2001), figure 5.
Edges dominanceFrontiers(const ControlFlow& flow) {
  Edges frontiers(flow.successors.size());
  for (std::size_t block = 0; block < flow.successors.size(); ++block) {
    if (!flow.reachable[block]) continue;
    for (int runner : flow.predecessors[block]) {
      if (!flow.reachable[static_cast<std::size_t>(runner)]) continue;
      for (; runner != flow.immediate_dominator[block] && runner != kNoBlock; runner = flow.immediate_dominator[static_cast<std::size_t>(runner)]) {
        std::vector<int>& frontier = frontiers[static_cast<std::size_t>(runner)];
        if (frontier.empty() || frontier.back() != static_cast<int>(block)) frontier.push_back(static_cast<int>(block));
      }
    }
  }
  return frontiers;
}

struct Variable {
  std::uint32_t id = 0, type_id = 0;
  std::uint32_t initial = 0;  // a constant; 0: undefined
  std::vector<int> stored_in, read_in;  // blocks; read before a store in them
};

class Promoter {
 public:
  Promoter(const Module& module, std::uint32_t function_id)
      : module_(module), types_(module), function_(*findFunction(module_, function_id)), access_(module, *findFunction(module, function_id)),
        flow_(analyseControlFlow(function_)) {}

  Module run() {
    for (const Instruction& instruction : function_.blocks.front().instructions)
      if (instruction.opcode == Op::OpVariable) consider(instruction);
    refuseIndexed();
    std::erase_if(variables_, [&](const Variable& variable) { return index_of_.count(variable.id) == 0; });
    if (variables_.empty()) return std::move(module_);
    for (std::size_t i = 0; i < variables_.size(); ++i) index_of_[variables_[i].id] = i;
    findNames();
    findUses();
    placePhis();
    rename();
    dropNamesOfNothing(module_);
    return std::move(module_);
  }

 private:
  void consider(const Instruction& instruction) {
    if (!access_.escaping(instruction.result_id).empty()) return;
    Variable variable{instruction.result_id, types_.pointee(instruction.type_id)};
    if (instruction.operands.size() > 1) variable.initial = instruction.word(1);
    const Instruction* initial = variable.initial == 0 ? nullptr : types_.find(variable.initial);
    if (initial != nullptr && initial->opcode == Op::OpVariable) return;  // the address of a global
    index_of_[variable.id] = variables_.size();
    variables_.push_back(std::move(variable));
  }

  // Those of which a part of an array or struct is accessed, or a column of a matrix by a variable index.
  void refuseIndexed() {
    for (const auto& [id, pointer] : access_.pointers()) {
      if (pointer.indices.empty()) continue;
      const auto found = index_of_.find(pointer.variable);
      if (found != index_of_.end() && !isPartOfValue(variables_[found->second].type_id, pointer.indices)) index_of_.erase(found);
    }
  }

  bool isPartOfValue(std::uint32_t type_id, const std::vector<std::uint32_t>& indices) const {
    const Instruction* type = types_.find(type_id);
    if (type == nullptr) return false;
    const auto inRange = [&](const Instruction& of, std::uint32_t index) {
      const std::optional<std::uint32_t> value = access_.constantIndex(index);
      return value && *value < of.word(1);
    };
    if (type->opcode == Op::OpTypeMatrix) {
      if (!inRange(*type, indices.front())) return false;
      return indices.size() == 1 || isPartOfValue(type->word(0), {indices.begin() + 1, indices.end()});
    }
    if (type->opcode != Op::OpTypeVector || indices.size() != 1) return false;
    return !access_.constantIndex(indices.front()) || inRange(*type, indices.front());
  }

  void findNames() {
    for (const Instruction& name : module_.names)
      if (name.opcode == Op::OpName && index_of_.count(name.word(0)) != 0) names_of_[name.word(0)].push_back(name);
    for (const Instruction& annotation : module_.annotations)
      if (annotation.opcode == Op::OpDecorate && index_of_.count(annotation.word(0)) != 0 &&
          static_cast<spv::Decoration>(annotation.word(1)) == spv::Decoration::RelaxedPrecision)
        names_of_[annotation.word(0)].push_back(annotation);
  }

  Variable* variableOf(std::uint32_t pointer) {
    const LocalPointer* local = access_.find(pointer);
    const auto found = local == nullptr ? index_of_.end() : index_of_.find(local->variable);
    return found == index_of_.end() ? nullptr : &variables_[found->second];
  }

  bool isPart(std::uint32_t pointer) const { return !access_.find(pointer)->indices.empty(); }

  void findUses() {
    for (std::size_t block = 0; block < function_.blocks.size(); ++block) {
      const int here = static_cast<int>(block);
      for (const Instruction& instruction : function_.blocks[block].instructions) {
        const bool loads = instruction.opcode == Op::OpLoad, stores = instruction.opcode == Op::OpStore;
        Variable* variable = loads || stores ? variableOf(instruction.word(0)) : nullptr;
        if (variable == nullptr) continue;
        const bool stored_here = !variable->stored_in.empty() && variable->stored_in.back() == here;
        // A stored part keeps the rest of the value.
        const bool reads = loads || isPart(instruction.word(0));
        if (reads && !stored_here && (variable->read_in.empty() || variable->read_in.back() != here)) variable->read_in.push_back(here);
        if (stores && !stored_here) variable->stored_in.push_back(here);
      }
    }
  }

  // Where the variable's value at the block's start is read later.
  std::vector<bool> liveAtStart(const Variable& variable) const {
    std::vector<bool> live(function_.blocks.size(), false), stored(function_.blocks.size(), false);
    for (const int block : variable.stored_in) stored[static_cast<std::size_t>(block)] = true;
    std::vector<int> work = variable.read_in;
    for (const int block : work) live[static_cast<std::size_t>(block)] = true;
    while (!work.empty()) {
      const auto block = static_cast<std::size_t>(work.back());
      work.pop_back();
      for (const int predecessor : flow_.predecessors[block]) {
        const auto from = static_cast<std::size_t>(predecessor);
        if (live[from] || stored[from]) continue;
        live[from] = true;
        work.push_back(predecessor);
      }
    }
    return live;
  }

  void placePhis() {
    const Edges frontiers = dominanceFrontiers(flow_);
    phis_of_.resize(function_.blocks.size());
    for (std::size_t index = 0; index < variables_.size(); ++index) {
      const Variable& variable = variables_[index];
      if (variable.read_in.empty()) continue;
      const std::vector<bool> live = liveAtStart(variable);
      std::vector<bool> placed(function_.blocks.size(), false);
      std::vector<int> work = variable.stored_in;
      while (!work.empty()) {
        const int block = work.back();
        work.pop_back();
        for (const int joined : frontiers[static_cast<std::size_t>(block)]) {
          if (placed[static_cast<std::size_t>(joined)] || !live[static_cast<std::size_t>(joined)]) continue;
          placed[static_cast<std::size_t>(joined)] = true;
          phis_of_[static_cast<std::size_t>(joined)].push_back({index, module_.freshId()});
          work.push_back(joined);
        }
      }
    }
  }

  struct PlacedPhi {
    std::size_t variable = 0;
    std::uint32_t id = 0;
  };

  std::uint32_t initialOf(const Variable& variable) {
    return variable.initial != 0 ? variable.initial : undefinedValue(module_, variable.type_id);
  }

  // Walks the dominator tree in the order of blocks, which is one of dominance; each block begins with what its dominator ended with.
  void rename() {
    std::vector<std::vector<std::uint32_t>> at_end(function_.blocks.size());
    std::vector<std::vector<Instruction>> code(function_.blocks.size());
    std::vector<std::vector<std::size_t>> dominated = childrenOf();
    std::vector<std::uint32_t> values;
    for (const Variable& variable : variables_) values.push_back(initialOf(variable));
    // By block, the values that it changed, to be put back when its subtree is done.
    struct Visit {
      std::size_t block = 0, next_child = 0;
      std::vector<std::pair<std::size_t, std::uint32_t>> before;
    };
    operands_.resize(function_.blocks.size());
    std::vector<Visit> stack;
    const auto enter = [&](std::size_t block) {
      Visit visit{block, 0, {}};
      rewriteBlock(block, values, visit.before, code[block]);
      for (const int successor : flow_.successors[block]) addOperands(static_cast<std::size_t>(successor), block, values);
      stack.push_back(std::move(visit));
    };
    enter(0);
    while (!stack.empty()) {
      Visit& visit = stack.back();
      if (visit.next_child < dominated[visit.block].size()) {
        enter(dominated[visit.block][visit.next_child++]);
        continue;
      }
      for (auto change = visit.before.rbegin(); change != visit.before.rend(); ++change) values[change->first] = change->second;
      stack.pop_back();
    }
    for (std::size_t block = 0; block < function_.blocks.size(); ++block)
      if (!flow_.reachable[block])
        for (const int successor : flow_.successors[block]) addUndefined(static_cast<std::size_t>(successor), block);
    finish(code);
  }

  std::vector<std::vector<std::size_t>> childrenOf() const {
    std::vector<std::vector<std::size_t>> children(function_.blocks.size());
    for (std::size_t block = 0; block < function_.blocks.size(); ++block)
      if (const int parent = flow_.immediate_dominator[block]; parent != kNoBlock) children[static_cast<std::size_t>(parent)].push_back(block);
    return children;
  }

  void addOperands(std::size_t block, std::size_t from, const std::vector<std::uint32_t>& values) {
    for (std::size_t i = 0; i < phis_of_[block].size(); ++i) {
      operands_[block].resize(phis_of_[block].size());
      operands_[block][i].push_back(idOperand(values[phis_of_[block][i].variable]));
      operands_[block][i].push_back(idOperand(function_.blocks[from].label));
    }
  }

  void addUndefined(std::size_t block, std::size_t from) {
    std::vector<std::uint32_t> values;
    for (const Variable& variable : variables_) values.push_back(phis_of_[block].empty() ? 0 : undefinedValue(module_, variable.type_id));
    addOperands(block, from, values);
  }

  void rewriteBlock(std::size_t index, std::vector<std::uint32_t>& values, std::vector<std::pair<std::size_t, std::uint32_t>>& before,
                    std::vector<Instruction>& code) {
    const auto set = [&](std::size_t variable, std::uint32_t value) {
      before.push_back({variable, values[variable]});
      values[variable] = value;
    };
    for (const PlacedPhi& phi : phis_of_[index]) set(phi.variable, phi.id);
    for (const Instruction& instruction : function_.blocks[index].instructions) {
      if (instruction.opcode == Op::OpVariable && index_of_.count(instruction.result_id) != 0) continue;
      if (instruction.result_id != 0 && variableOf(instruction.result_id) != nullptr) continue;  // a chain
      const bool loads = instruction.opcode == Op::OpLoad, stores = instruction.opcode == Op::OpStore;
      const Variable* variable = loads || stores ? variableOf(instruction.word(0)) : nullptr;
      if (variable == nullptr) {
        code.push_back(instruction);
        continue;
      }
      const std::size_t which = index_of_.at(variable->id);
      Builder build(module_, code, instruction.line);
      const std::vector<std::uint32_t>& indices = access_.find(instruction.word(0))->indices;
      if (loads) {
        replaced_[instruction.result_id] = read(build, variable->type_id, values[which], indices);
      } else {
        set(which, write(build, {variable->type_id, values[which]}, indices, instruction.word(1)));
      }
    }
  }

  std::uint32_t read(Builder& build, std::uint32_t type_id, std::uint32_t value, const std::vector<std::uint32_t>& indices) const {
    for (const std::uint32_t index : indices) {
      const std::uint32_t part_type = types_.at(type_id, 0);
      const std::optional<std::uint32_t> literal = access_.constantIndex(index);
      const std::uint32_t path[] = {literal.value_or(0)};
      value = literal ? build.extract(part_type, value, path) : build.result(Op::OpVectorExtractDynamic, part_type, {idOperand(value), idOperand(index)});
      type_id = part_type;
    }
    return value;
  }

  struct Whole {
    std::uint32_t type_id = 0, value = 0;
  };

  std::uint32_t write(Builder& build, const Whole& whole, const std::vector<std::uint32_t>& indices, std::uint32_t part) const {
    if (indices.empty()) return part;
    std::vector<std::uint32_t> literals;
    for (const std::uint32_t index : indices)
      if (const auto literal = access_.constantIndex(index)) literals.push_back(*literal);
    if (literals.size() == indices.size()) return build.insert(whole.type_id, part, whole.value, literals);
    // Only the last index, that of a vector's component, may be a variable.
    std::uint32_t vector_type = whole.type_id, vector = whole.value;
    if (!literals.empty()) {
      vector_type = types_.at(whole.type_id, literals.front());
      vector = build.extract(vector_type, whole.value, literals);
    }
    const std::uint32_t changed = build.result(Op::OpVectorInsertDynamic, vector_type, {idOperand(vector), idOperand(part), idOperand(indices.back())});
    return literals.empty() ? changed : build.insert(whole.type_id, changed, whole.value, literals);
  }

  void finish(std::vector<std::vector<Instruction>>& code) {
    for (std::size_t block = 0; block < function_.blocks.size(); ++block) {
      std::vector<Instruction>& instructions = function_.blocks[block].instructions;
      if (flow_.reachable[block]) instructions = std::move(code[block]);
      std::vector<Instruction> phis;
      for (std::size_t i = 0; i < phis_of_[block].size(); ++i) phis.push_back(makePhi(phis_of_[block][i], std::move(operands_[block][i])));
      instructions.insert(instructions.begin(), std::make_move_iterator(phis.begin()), std::make_move_iterator(phis.end()));
    }
    substituteIds(function_, replaced_);
  }

  Instruction makePhi(const PlacedPhi& placed, std::vector<Operand> operands) {
    const Variable& variable = variables_[placed.variable];
    for (const Instruction& name : names_of_[variable.id]) {
      Instruction copy = name;
      copy.operands[0] = idOperand(placed.id);
      (name.opcode == Op::OpName ? module_.names : module_.annotations).push_back(std::move(copy));
    }
    return makeInstruction(Op::OpPhi, variable.type_id, placed.id, std::move(operands));
  }

  Module module_;
  const Types types_;
  Function& function_;
  const LocalAccess access_;
  const ControlFlow flow_;
  std::vector<Variable> variables_;
  std::unordered_map<std::uint32_t, std::size_t> index_of_;  // of promoted variables, by id
  std::vector<std::vector<PlacedPhi>> phis_of_;              // by block
  std::vector<std::vector<std::vector<Operand>>> operands_;  // by block and phi
  std::unordered_map<std::uint32_t, std::uint32_t> replaced_;  // loads -> values
  std::unordered_map<std::uint32_t, std::vector<Instruction>> names_of_;  // OpName and RelaxedPrecision, by variable
};

}  // namespace

Module promoteVariables(const Module& module, std::uint32_t function) { return Promoter(module, function).run(); }

}  // namespace reprise

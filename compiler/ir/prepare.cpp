#include "compiler/ir/prepare.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_set>
#include <vector>

#include "compiler/ir/inline_calls.h"
#include "compiler/ir/loop_results.h"
#include "compiler/ir/promote_to_ssa.h"
#include "compiler/ir/return_flags.h"
#include "compiler/ir/unroll.h"

namespace reprise {
namespace {

using spv::Op;

// glslang's name for the temporaries that carry arguments; the callee's own name for the parameter follows.
constexpr const char* kArgumentTemporary = "param";

std::unordered_map<std::uint32_t, std::string> namesById(const Module& module) {
  std::unordered_map<std::uint32_t, std::string> names;
  for (const Instruction& name : module.names)
    if (name.opcode == Op::OpName) names[name.word(0)] = stringOf(name.operands[1]);
  return names;
}

// Scalars and vectors of any width: those that cannot be kept are reported by name, too.
std::unordered_set<std::uint32_t> namedTypes(const Module& module) {
  std::unordered_set<std::uint32_t> types;
  for (const Instruction& global : module.globals)
    if (global.opcode == Op::OpTypeFloat || global.opcode == Op::OpTypeInt || global.opcode == Op::OpTypeBool ||
        (global.opcode == Op::OpTypeVector && types.count(global.word(0)) != 0))
      types.insert(global.result_id);
  return types;
}

std::unordered_set<std::uint32_t> variablesOf(const Module& module, const Function& function) {
  std::unordered_set<std::uint32_t> variables;
  for (const Instruction& instruction : function.blocks.front().instructions)
    if (instruction.opcode == Op::OpVariable) variables.insert(instruction.result_id);
  for (const Instruction& global : module.globals)
    if (global.opcode == Op::OpVariable && global.word(0) == static_cast<std::uint32_t>(spv::StorageClass::Output))
      variables.insert(global.result_id);
  return variables;
}

using LineNames = std::map<std::pair<std::uint32_t, std::uint32_t>, std::set<std::string>>;

// Inlining gives a callee's locals new ids without names, but its stores keep their lines: which names are stored on a line.
LineNames namesStoredOnLines(const Module& module) {
  const auto names = namesById(module);
  LineNames stored;
  for (const Function& function : module.functions)
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions) {
        if (instruction.opcode != Op::OpStore || instruction.line.line == 0) continue;
        const auto name = names.find(instruction.word(0));
        if (name != names.end() && name->second != kArgumentTemporary)
          stored[{instruction.line.file, instruction.line.line}].insert(name->second);
      }
  return stored;
}

// The name of the variable that a store writes: its own, or the only one that the source stores on that line.
std::string storedName(const Instruction& store, const std::unordered_map<std::uint32_t, std::string>& names, const LineNames& on_lines) {
  const auto own = names.find(store.word(0));
  if (own != names.end() && !own->second.empty()) return own->second == kArgumentTemporary ? "" : own->second;
  const auto found = on_lines.find({store.line.file, store.line.line});
  return found != on_lines.end() && found->second.size() == 1 ? *found->second.begin() : "";
}

Module nameStoredValues(const Module& module, std::uint32_t entry_function, const LineNames& on_lines) {
  Module named = module;
  const auto names = namesById(module);
  const auto types = resultTypes(module);
  const auto named_types = namedTypes(module);
  Function& function = *findFunction(named, entry_function);
  const auto variables = variablesOf(module, function);
  for (Block& block : function.blocks) {
    std::vector<Instruction> instructions;
    for (Instruction& instruction : block.instructions) {
      const bool stores = instruction.opcode == Op::OpStore && variables.count(instruction.word(0)) != 0;
      const std::string name = stores ? storedName(instruction, names, on_lines) : "";
      const auto type = stores ? types.find(instruction.word(1)) : types.end();
      if (!name.empty() && type != types.end() && named_types.count(type->second) != 0) {
        const std::uint32_t copy = named.freshId();
        instructions.push_back(makeInstruction(Op::OpCopyObject, type->second, copy, {instruction.operands[1]}));
        instructions.back().line = instruction.line;
        named.names.push_back(makeInstruction(Op::OpName, 0, 0, {idOperand(copy), stringOperand(name)}));
        instruction.operands[1] = idOperand(copy);
      }
      instructions.push_back(std::move(instruction));
    }
    block.instructions = std::move(instructions);
  }
  return named;
}

// The integer scalars among the types: those of loop counters.
std::unordered_set<std::uint32_t> counterTypes(const Module& module) {
  std::unordered_set<std::uint32_t> types;
  for (const Instruction& global : module.globals)
    if (global.opcode == Op::OpTypeInt) types.insert(global.result_id);
  return types;
}

// Folds OpCopyObjects of the entry function, of the given types or all where there are none, and records the names that the
// copies carried. The copies of unrolled iterations have none of their own but keep their lines.
void foldCopies(PreparedShader& shader, const LineNames& on_lines, const std::unordered_set<std::uint32_t>& types = {}) {
  const auto names = namesById(shader.module);
  Function& function = *findFunction(shader.module, shader.entry_function);
  const auto folds = [&](const Instruction& instruction) {
    return instruction.opcode == Op::OpCopyObject && (types.empty() || types.count(instruction.type_id) != 0);
  };
  const auto nameOfCopy = [&](const Instruction& copy) -> std::string {
    if (const auto own = names.find(copy.result_id); own != names.end()) return own->second;
    const auto found = on_lines.find({copy.line.file, copy.line.line});
    return found != on_lines.end() && found->second.size() == 1 ? *found->second.begin() : "";
  };
  std::unordered_set<std::uint32_t> globals;
  for (const Instruction& global : shader.module.globals) globals.insert(global.result_id);
  std::unordered_map<std::uint32_t, std::uint32_t> source;
  const auto resolve = [&](std::uint32_t id) {
    for (auto found = source.find(id); found != source.end(); found = source.find(id)) id = found->second;
    return id;
  };
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions)
      if (folds(instruction)) source[instruction.result_id] = instruction.word(0);
  for (Block& block : function.blocks) {
    std::vector<Instruction> kept;
    for (Instruction& instruction : block.instructions) {
      if (folds(instruction)) {
        // A constant is the start of many variables and bears the name of none.
        const std::string name = globals.count(resolve(instruction.result_id)) == 0 ? nameOfCopy(instruction) : "";
        if (!name.empty()) shader.named[resolve(instruction.result_id)] = {name, instruction.line};
        continue;
      }
      for (Operand& operand : instruction.operands)
        if (operand.is_id) operand.words[0] = resolve(operand.words[0]);
      kept.push_back(std::move(instruction));
    }
    block.instructions = std::move(kept);
  }
  std::erase_if(shader.module.names, [&](const Instruction& name) {
    return name.opcode == Op::OpName && source.count(name.word(0)) != 0;
  });
  std::erase_if(shader.module.annotations, [&](const Instruction& annotation) {
    return annotation.opcode == Op::OpDecorate && source.count(annotation.word(0)) != 0;
  });
}

// A phi has the name of the variable that it was made for; one that came with the module, that of the values it joins, if they have
// one in common. Its line is that of an assignment that it joins.
void namePhis(PreparedShader& shader) {
  const auto own_names = namesById(shader.module);
  const auto namesJoined = [&](const Instruction& phi) {
    std::vector<NamedValue> joined;
    for (std::size_t i = 0; i < phi.operands.size(); i += 2)
      if (const auto name = shader.named.find(phi.word(i)); name != shader.named.end()) joined.push_back(name->second);
    return joined;
  };
  for (const Block& block : findFunction(shader.module, shader.entry_function)->blocks)
    for (const Instruction& instruction : block.instructions) {
      if (instruction.opcode != Op::OpPhi || shader.named.count(instruction.result_id) != 0) continue;
      const std::vector<NamedValue> joined = namesJoined(instruction);
      const auto own = own_names.find(instruction.result_id);
      if (own != own_names.end() && own->second != kArgumentTemporary) {
        shader.named[instruction.result_id] = {own->second, joined.empty() ? instruction.line : joined.front().line};
      } else if (!joined.empty() && std::all_of(joined.begin(), joined.end(), [&](const NamedValue& one) { return one.name == joined.front().name; })) {
        shader.named[instruction.result_id] = joined.front();
      }
    }
}

// What a loop leaves behind gets the name that the loop's value has.
void nameLoopResults(PreparedShader& shader) {
  LoopClosed closed = closeLoops(shader.module, shader.entry_function);
  shader.module = std::move(closed.module);
  // A value that leaves several loops: from phi to phi.
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [value, phi] : closed.result_of)
      if (const auto name = shader.named.find(value); name != shader.named.end() && shader.named.count(phi) == 0) {
        shader.named[phi] = NamedValue(name->second);
        changed = true;
      }
  }
}

}  // namespace

std::unordered_map<std::uint32_t, std::uint32_t> resultTypes(const Module& module) {
  std::unordered_map<std::uint32_t, std::uint32_t> types;
  for (const Instruction& global : module.globals)
    if (global.type_id != 0) types[global.result_id] = global.type_id;
  for (const Function& function : module.functions) {
    for (const Instruction& parameter : function.parameters) types[parameter.result_id] = parameter.type_id;
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (instruction.result_id != 0) types[instruction.result_id] = instruction.type_id;
  }
  return types;
}

Result<PreparedShader> prepareForCaching(const Module& module, const std::string& entry_point) {
  const Instruction* entry = findEntryPoint(module, entry_point);
  if (entry == nullptr)
    return Error{ErrorKind::kInput, "spirv.entry_point",
                 entry_point.empty() ? "the module has " + std::to_string(module.entry_points.size()) +
                                           " entry points; name one of them"
                                     : "the module has no entry point '" + entry_point + "'",
                 {}};
  const std::uint32_t function_id = entry->word(1);
  const std::string name = stringOf(entry->operands[2]);
  REPRISE_ASSIGN(const Module inlined, inlineCalls(module));
  for (const Function& function : inlined.functions)
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        if (instruction.opcode == Op::OpFunctionCall)
          return Error{ErrorKind::kRefused, "call.kept",
                       "the function '" + nameOf(inlined, instruction.word(0)) +
                           "' cannot be inlined, so its values cannot be told apart", {}};
  const LineNames on_lines = namesStoredOnLines(module);
  REPRISE_ASSIGN(Module promoted, promoteToSsa(nameStoredValues(inlined, function_id, on_lines)));
  PreparedShader shader{std::move(promoted), function_id, {}, {}};
  dropReturnFlagNames(shader.module);
  REPRISE_CHECK(findFunction(shader.module, function_id) != nullptr, name);
  // Counters first: a loop whose step is a copy is not seen to count.
  foldCopies(shader, on_lines, counterTypes(shader.module));
  REPRISE_ASSIGN(shader.module, unrollShortLoops(shader.module, function_id));
  foldCopies(shader, on_lines);
  namePhis(shader);
  nameLoopResults(shader);
  if (hasReturnFlags(inlined)) shader.return_flags = flagsOfReturns(shader.module, function_id);
  return shader;
}

}  // namespace reprise

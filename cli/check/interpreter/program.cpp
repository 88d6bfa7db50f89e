#define SPV_ENABLE_UTILITY_CODE
#include "cli/check/interpreter/program.h"

#include <algorithm>

#include "cli/check/interpreter/read_types.h"

namespace reprise::interpreter {
namespace {

using spv::Op;

constexpr std::size_t kHeaderWords = 5;

struct RawInstruction {
  Op op = Op::OpNop;
  std::uint32_t type_id = 0, result = 0;
  std::span<const std::uint32_t> operands;
};

// SPIR-V packs text into words, the first byte lowest; counts the words that the text takes.
std::string textOf(std::span<const std::uint32_t> words, std::size_t* taken = nullptr) {
  std::string text;
  std::size_t i = 0;
  for (bool ended = false; i < words.size() && !ended; ++i)
    for (int byte = 0; byte < 4 && !ended; ++byte) {
      const char one = static_cast<char>((words[i] >> (8 * byte)) & 0xff);
      if (one == 0) ended = true;
      else text += one;
    }
  if (taken != nullptr) *taken = i;
  return text;
}

bool isTerminator(Op op) {
  switch (op) {
    case Op::OpBranch: case Op::OpBranchConditional: case Op::OpSwitch: case Op::OpReturn: case Op::OpReturnValue: case Op::OpKill:
    case Op::OpTerminateInvocation: case Op::OpUnreachable: return true;
    default: return false;
  }
}

bool saysNothing(Op op) {
  return op == Op::OpNop || op == Op::OpLine || op == Op::OpNoLine || op == Op::OpLoopMerge || op == Op::OpSelectionMerge;
}

class Reader {
 public:
  Reader(std::span<const std::uint32_t> words, std::string entry_point) : wanted_(std::move(entry_point)) {
    program_.words.assign(words.begin(), words.end());
  }

  Result<Program> read() {
    const std::vector<std::uint32_t>& words = program_.words;
    if (words.size() < kHeaderWords || words[0] != spv::MagicNumber) return invalid("it does not begin as SPIR-V");
    if (words[3] == 0 || words[3] > kMostIds) return invalid("its bound of ids is " + std::to_string(words[3]));
    program_.ids.resize(words[3]);
    types_.emplace(program_);
    for (std::size_t at = kHeaderWords; at < words.size();) {
      const std::size_t count = words[at] >> 16;
      if (count == 0 || at + count > words.size()) return invalid("an instruction does not end");
      RawInstruction raw;
      raw.op = static_cast<Op>(words[at] & 0xffff);
      std::span<const std::uint32_t> rest = std::span(words).subspan(at + 1, count - 1);
      bool has_result = false, has_type = false;
      spv::HasResultAndType(raw.op, &has_result, &has_type);
      if (rest.size() < std::size_t{has_result} + std::size_t{has_type}) return invalid("an instruction is too short");
      if (has_type) raw.type_id = rest[0], rest = rest.subspan(1);
      if (has_result) raw.result = rest[0], rest = rest.subspan(1);
      if (has_result && (raw.result == 0 || raw.result >= words[3])) return invalid("a result is not below the bound of ids");
      raw.operands = rest;
      REPRISE_TRY(take(raw));
      at += count;
    }
    return finish();
  }

 private:
  Result<void> take(const RawInstruction& raw) {
    if (saysNothing(raw.op)) return {};
    if (function_ != nullptr || raw.op == Op::OpFunction) return takeOfFunction(raw);
    switch (raw.op) {
      case Op::OpEntryPoint: return takeEntryPoint(raw);
      case Op::OpExtInstImport: program_.imports[raw.result] = textOf(raw.operands); return {};
      case Op::OpVariable: return takeGlobal(raw);
      case Op::OpExtInst: return {};  // no set that says anything has instructions outside functions
      default: break;
    }
    if (isDecoration(raw.op)) return types_->decorate(raw.op, raw.result, raw.operands);
    if (isType(raw.op)) return types_->define(raw.op, raw.result, raw.operands);
    if (raw.type_id == 0 || raw.result == 0) return {};  // capabilities, names, ...
    return takeConstant(raw);
  }

  Result<void> takeEntryPoint(const RawInstruction& raw) {
    if (raw.operands.size() < 3) return invalid("an entry point is too short");
    if (static_cast<spv::ExecutionModel>(raw.operands[0]) != spv::ExecutionModel::Fragment) return {};
    std::size_t taken = 0;
    const std::string name = textOf(raw.operands.subspan(2), &taken);
    if (!wanted_.empty() && name != wanted_) return {};
    if (entry_id_ != 0) return invalid("it has several entry points; name one of them");
    entry_id_ = raw.operands[1];
    const auto interface = raw.operands.subspan(2 + taken);
    program_.interface.assign(interface.begin(), interface.end());
    return {};
  }

  // The type of a result; null where it has none that is known.
  const Type* typeOf(std::uint32_t id, std::uint32_t& index) const {
    if (id >= program_.ids.size() || program_.ids[id].what != IdInfo::What::kType) return nullptr;
    index = program_.ids[id].type;
    return &program_.types[index];
  }

  // Registers for a result, of the function at hand or of the module.
  Result<void> define(const RawInstruction& raw, std::uint32_t& type) {
    if (program_.ids[raw.result].what != IdInfo::What::kNothing) return invalid("an id is defined twice");
    const Type* found = typeOf(raw.type_id, type);
    if (found == nullptr) return invalid("a result has no type");
    if (found->flat > kMostScalars) return unsupported("values of more than " + std::to_string(kMostScalars) + " components");
    std::uint32_t& registers = function_ != nullptr ? function_->registers : program_.registers;
    const std::uint32_t owner = function_ != nullptr ? static_cast<std::uint32_t>(program_.functions.size()) : 0;
    program_.ids[raw.result] = {IdInfo::What::kValue, type, registers, owner, found->flat};
    registers += found->flat;
    if (registers > kMostMemory) return unsupported("functions with more than " + std::to_string(kMostMemory) + " components of values");
    return {};
  }

  Result<void> takeConstant(const RawInstruction& raw) {
    Instruction constant{raw.op, 0, raw.result, raw.operands, nullptr};
    REPRISE_TRY(define(raw, constant.type));
    if (raw.op == Op::OpSpecConstantOp) {
      if (raw.operands.empty()) return invalid("a constant is too short");
      constant.op = static_cast<Op>(raw.operands[0]);
      constant.operands = raw.operands.subspan(1);
    }
    constant.handler = handlerOf(constant.op);
    if ((constant.op == Op::OpConstant || constant.op == Op::OpSpecConstant) && raw.operands.size() == 1)
      program_.integers[raw.result] = raw.operands[0];
    program_.constants.push_back(constant);
    return {};
  }

  Result<Variable> variableOf(const RawInstruction& raw, std::uint32_t& memory) {
    Variable variable;
    std::uint32_t pointer = 0;
    REPRISE_TRY(define(raw, pointer));
    if (program_.types[pointer].kind != Kind::kPointer || raw.operands.empty()) return invalid("a variable is no pointer");
    variable.id = raw.result;
    variable.type = program_.types[pointer].element;
    variable.storage = static_cast<spv::StorageClass>(raw.operands[0]);
    variable.initializer = raw.operands.size() > 1 ? raw.operands[1] : 0;
    variable.decorations = types_->decorationsOf(raw.result);
    switch (variable.storage) {
      case spv::StorageClass::Uniform: case spv::StorageClass::StorageBuffer: case spv::StorageClass::PushConstant:
      case spv::StorageClass::UniformConstant: return variable;
      default: break;
    }
    const Type& type = program_.types[variable.type];
    if (type.flat > kMostScalars) return unsupported("variables of more than " + std::to_string(kMostScalars) + " components");
    variable.place = memory;
    memory += type.flat;
    if (memory > kMostMemory) return unsupported("more than " + std::to_string(kMostMemory) + " components of variables");
    return variable;
  }

  Result<void> takeGlobal(const RawInstruction& raw) {
    REPRISE_ASSIGN(const Variable variable, variableOf(raw, program_.memory));
    program_.variables.push_back(variable);
    return {};
  }

  Result<void> takeOfFunction(const RawInstruction& raw) {
    switch (raw.op) {
      case Op::OpFunction:
        if (function_ != nullptr) return invalid("a function is not ended");
        program_.ids[raw.result] = {IdInfo::What::kFunction, 0, static_cast<std::uint32_t>(program_.functions.size()), 0, 0};
        function_ = &program_.functions.emplace_back();
        function_->id = raw.result;
        return {};
      case Op::OpFunctionEnd:
        function_ = nullptr;
        in_block_ = false;
        return {};
      case Op::OpFunctionParameter: {
        std::uint32_t type = 0;
        REPRISE_TRY(define(raw, type));
        function_->parameters.push_back(raw.result);
        return {};
      }
      case Op::OpLabel: {
        const auto owner = static_cast<std::uint32_t>(program_.functions.size());
        program_.ids[raw.result] = {IdInfo::What::kLabel, 0, static_cast<std::uint32_t>(function_->blocks.size()), owner, 0};
        Block& block = function_->blocks.emplace_back();
        block.label = raw.result;
        block.number = program_.blocks++;
        in_block_ = true;
        return {};
      }
      case Op::OpVariable: {
        REPRISE_ASSIGN(const Variable variable, variableOf(raw, function_->memory));
        function_->variables.push_back(variable);
        return {};
      }
      default: return takeOfBlock(raw);
    }
  }

  Result<void> takeOfBlock(const RawInstruction& raw) {
    if (!in_block_) return invalid("an instruction lies outside all blocks");
    Instruction instruction{raw.op, 0, raw.result, raw.operands, handlerOf(raw.op)};
    if (raw.op == Op::OpExtInst) {
      if (raw.operands.size() < 2) return invalid("an extended instruction is too short");
      const auto import = program_.imports.find(raw.operands[0]);
      const std::string set = import == program_.imports.end() ? "" : import->second;
      if (set.starts_with("NonSemantic.")) return {};
      instruction.handler = extendedHandler(set, raw.operands[1]);
    }
    if (raw.result != 0 && raw.type_id != 0) REPRISE_TRY(define(raw, instruction.type));
    function_->blocks.back().instructions.push_back(instruction);
    if (isTerminator(raw.op)) in_block_ = false;
    return {};
  }

  Result<Program> finish() {
    if (function_ != nullptr) return invalid("a function is not ended");
    if (entry_id_ == 0) return invalid(wanted_.empty() ? "it has no fragment entry point" : "it has no fragment entry point '" + wanted_ + "'");
    if (entry_id_ >= program_.ids.size() || program_.ids[entry_id_].what != IdInfo::What::kFunction)
      return invalid("its entry point is no function");
    program_.entry = program_.ids[entry_id_].slot;
    return std::move(program_);
  }

  std::string wanted_;
  Program program_;
  std::optional<TypeReader> types_;
  Function* function_ = nullptr;
  bool in_block_ = false;
  std::uint32_t entry_id_ = 0;
};

}  // namespace

Error invalid(const std::string& what) {
  return {ErrorKind::kInput, "interpreter.invalid", "the module cannot be interpreted: " + what, {}};
}

Error unsupported(const std::string& what) {
  return {ErrorKind::kRefused, "interpreter.unsupported", "the reference interpreter has no " + what, {}};
}

Result<Program> readProgram(std::span<const std::uint32_t> words, const std::string& entry_point) {
  return Reader(words, entry_point).read();
}

}  // namespace reprise::interpreter

// Reading and writing the binary form, on top of spvBinaryParse, which knows every opcode's operands.
#include <spirv-tools/libspirv.h>

#include <memory>

#include "compiler/ir/module.h"

namespace reprise {
namespace {

using spv::Op;

struct Reader {
  Module module;
  LineMark line;
  bool in_function = false;
  std::string failure;
  std::string failure_code = "spirv.invalid";
};

bool isIdType(spv_operand_type_t type) {
  switch (type) {
    case SPV_OPERAND_TYPE_ID:
    case SPV_OPERAND_TYPE_TYPE_ID:
    case SPV_OPERAND_TYPE_RESULT_ID:
    case SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID:
    case SPV_OPERAND_TYPE_SCOPE_ID:
      return true;
    default:
      return false;
  }
}

Instruction convert(const spv_parsed_instruction_t& parsed) {
  Instruction instruction;
  instruction.opcode = static_cast<Op>(parsed.opcode);
  instruction.type_id = parsed.type_id;
  instruction.result_id = parsed.result_id;
  for (int i = 0; i < parsed.num_operands; ++i) {
    const spv_parsed_operand_t& operand = parsed.operands[i];
    if (operand.type == SPV_OPERAND_TYPE_TYPE_ID && parsed.words[operand.offset] == parsed.type_id && i == 0 &&
        parsed.type_id != 0)
      continue;
    if (operand.type == SPV_OPERAND_TYPE_RESULT_ID) continue;
    const std::uint32_t* first = parsed.words + operand.offset;
    instruction.operands.push_back({isIdType(operand.type), {first, first + operand.num_words}});
  }
  return instruction;
}

std::vector<Instruction>* sectionOf(Module& module, Op opcode) {
  switch (opcode) {
    case Op::OpCapability: return &module.capabilities;
    case Op::OpExtension: return &module.extensions;
    case Op::OpExtInstImport: return &module.imports;
    case Op::OpMemoryModel: return &module.memory_model;
    case Op::OpEntryPoint: return &module.entry_points;
    case Op::OpExecutionMode:
    case Op::OpExecutionModeId: return &module.execution_modes;
    case Op::OpString:
    case Op::OpSource:
    case Op::OpSourceContinued:
    case Op::OpSourceExtension: return &module.debug_sources;
    case Op::OpName:
    case Op::OpMemberName: return &module.names;
    case Op::OpModuleProcessed: return &module.processed;
    case Op::OpDecorate:
    case Op::OpMemberDecorate:
    case Op::OpDecorationGroup:
    case Op::OpGroupDecorate:
    case Op::OpGroupMemberDecorate:
    case Op::OpDecorateId:
    case Op::OpDecorateString:
    case Op::OpMemberDecorateString: return &module.annotations;
    default: return &module.globals;
  }
}

bool isTerminator(Op opcode) {
  switch (opcode) {
    case Op::OpBranch:
    case Op::OpBranchConditional:
    case Op::OpSwitch:
    case Op::OpReturn:
    case Op::OpReturnValue:
    case Op::OpKill:
    case Op::OpUnreachable:
    case Op::OpTerminateInvocation:
      return true;
    default:
      return false;
  }
}

// False if the instruction cannot stand where it does.
bool placeInFunction(Reader& reader, Instruction instruction) {
  Function& function = reader.module.functions.back();
  if (instruction.opcode == Op::OpFunction) return false;
  if (instruction.opcode == Op::OpFunctionEnd) {
    reader.in_function = false;
    return true;
  }
  if (instruction.opcode == Op::OpFunctionParameter) {
    function.parameters.push_back(std::move(instruction));
    return true;
  }
  if (instruction.opcode == Op::OpLabel) {
    function.blocks.push_back({instruction.result_id, {}});
    return true;
  }
  if (function.blocks.empty()) return false;
  function.blocks.back().instructions.push_back(std::move(instruction));
  return true;
}

spv_result_t onHeader(void* user, spv_endianness_t, std::uint32_t, std::uint32_t version, std::uint32_t,
                      std::uint32_t bound, std::uint32_t) {
  auto& reader = *static_cast<Reader*>(user);
  reader.module.version = version;
  reader.module.bound = bound;
  if (bound <= kMostReadIds) return SPV_SUCCESS;
  reader.failure_code = "spirv.limit";
  reader.failure = "the module declares " + std::to_string(bound) + " ids; at most " + std::to_string(kMostReadIds) + " are read";
  return SPV_ERROR_INVALID_BINARY;
}

spv_result_t onInstruction(void* user, const spv_parsed_instruction_t* parsed) {
  auto& reader = *static_cast<Reader*>(user);
  Instruction instruction = convert(*parsed);
  if (instruction.opcode == Op::OpLine) {
    reader.line = {instruction.word(0), instruction.word(1), instruction.word(2)};
    return SPV_SUCCESS;
  }
  if (instruction.opcode == Op::OpNoLine) {
    reader.line = {};
    return SPV_SUCCESS;
  }
  instruction.line = reader.line;
  if (instruction.opcode == Op::OpFunction && !reader.in_function) {
    reader.in_function = true;
    reader.line = {};
    instruction.line = {};
    reader.module.functions.push_back({std::move(instruction), {}, {}});
    return SPV_SUCCESS;
  }
  if (reader.in_function) {
    if (placeInFunction(reader, std::move(instruction))) return SPV_SUCCESS;
    reader.failure = "an instruction stands where none of its kind may, outside any block or within a function";
    return SPV_ERROR_INVALID_BINARY;
  }
  if (instruction.opcode == Op::OpFunctionEnd || instruction.opcode == Op::OpFunctionParameter || instruction.opcode == Op::OpLabel) {
    reader.failure = "an instruction of a function stands outside any function";
    return SPV_ERROR_INVALID_BINARY;
  }
  std::vector<Instruction>* section = sectionOf(reader.module, instruction.opcode);
  if (section != &reader.module.globals) instruction.line = {};
  section->push_back(std::move(instruction));
  return SPV_SUCCESS;
}

class Writer {
 public:
  explicit Writer(const Module& module) {
    words_ = {0x07230203u, module.version, 0u, module.bound, 0u};
  }

  void section(const std::vector<Instruction>& instructions) {
    for (const Instruction& instruction : instructions) write(instruction);
  }

  void function(const Function& function) {
    line_ = {};
    write(function.definition);
    section(function.parameters);
    for (const Block& block : function.blocks) {
      write(makeInstruction(Op::OpLabel, 0, block.label, {}));
      block_starts_ = true;
      for (const Instruction& instruction : block.instructions) write(instruction);
    }
    write(makeInstruction(Op::OpFunctionEnd, 0, 0, {}));
  }

  std::vector<std::uint32_t> take() { return std::move(words_); }

 private:
  void write(const Instruction& instruction) {
    if (instruction.opcode != Op::OpLabel && instruction.opcode != Op::OpFunctionEnd) moveTo(instruction.line);
    raw(instruction);
  }

  // The scope of a line ends with its block, but glslang states a line only where it changes: reading carries lines over to the
  // next block, writing states them anew.
  void moveTo(const LineMark& line) {
    const bool known = line.line != 0 || line.file != 0;
    const bool again = block_starts_ && known;
    block_starts_ = false;
    if (line == line_ && !again) return;
    line_ = line;
    if (line.line == 0 && line.file == 0) {
      raw(makeInstruction(Op::OpNoLine, 0, 0, {}));
    } else {
      raw(makeInstruction(Op::OpLine, 0, 0, {idOperand(line.file), literalOperand(line.line), literalOperand(line.column)}));
    }
  }

  void raw(const Instruction& instruction) {
    const std::size_t start = words_.size();
    words_.push_back(0);
    if (instruction.type_id != 0) words_.push_back(instruction.type_id);
    if (instruction.result_id != 0) words_.push_back(instruction.result_id);
    for (const Operand& operand : instruction.operands)
      words_.insert(words_.end(), operand.words.begin(), operand.words.end());
    words_[start] = static_cast<std::uint32_t>((words_.size() - start) << 16) | static_cast<std::uint32_t>(instruction.opcode);
  }

  std::vector<std::uint32_t> words_;
  LineMark line_;
  bool block_starts_ = false;
};

}  // namespace

Result<Module> readModule(std::span<const std::uint32_t> words) {
  const std::unique_ptr<spv_context_t, void (*)(spv_context)> context(spvContextCreate(SPV_ENV_UNIVERSAL_1_6),
                                                                      spvContextDestroy);
  Reader reader;
  spv_diagnostic raw_diagnostic = nullptr;
  const spv_result_t status = spvBinaryParse(context.get(), &reader, words.data(), words.size(), onHeader,
                                             onInstruction, &raw_diagnostic);
  const std::unique_ptr<spv_diagnostic_t, void (*)(spv_diagnostic)> diagnostic(raw_diagnostic, spvDiagnosticDestroy);
  if (status != SPV_SUCCESS) {
    std::string message = !reader.failure.empty() ? reader.failure
                          : diagnostic          ? diagnostic->error
                                                : "not a SPIR-V module";
    return Error{ErrorKind::kInput, reader.failure_code, "the SPIR-V cannot be read: " + message, {}};
  }
  for (const Function& function : reader.module.functions)
    for (const Block& block : function.blocks)
      if (block.instructions.empty() || !isTerminator(block.terminator().opcode))
        return Error{ErrorKind::kInput, "spirv.invalid", "a block of the SPIR-V module has no terminator", {}};
  return std::move(reader.module);
}

std::vector<std::uint32_t> writeModule(const Module& module) {
  Writer writer(module);
  for (const auto* section : {&module.capabilities, &module.extensions, &module.imports, &module.memory_model,
                              &module.entry_points, &module.execution_modes, &module.debug_sources, &module.names, &module.processed,
                              &module.annotations, &module.globals})
    writer.section(*section);
  for (const Function& function : module.functions) writer.function(function);
  return writer.take();
}

}  // namespace reprise

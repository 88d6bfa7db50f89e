// A SPIR-V module as plain values: instructions with typed operands, in the sections of the SPIR-V specification
// (2.4, logical layout), functions as lists of blocks.
//
// readModule(writeModule(m)) == m for every module that readModule returned (law 6). Line information is held by each
// instruction instead of OpLine/OpNoLine between them, so that instructions may be moved, cloned and dropped freely.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

struct Operand {
  bool is_id = false;                // words[0] is an id that the instruction uses
  std::vector<std::uint32_t> words;  // one word but for strings and wide literals
  bool operator==(const Operand&) const = default;
};

// file is the id of an OpString; line 0: no line known.
struct LineMark {
  std::uint32_t file = 0, line = 0, column = 0;
  bool operator==(const LineMark&) const = default;
};

struct Instruction {
  spv::Op opcode = spv::Op::OpNop;
  std::uint32_t type_id = 0;    // 0: the instruction has no result type
  std::uint32_t result_id = 0;  // 0: it has no result
  std::vector<Operand> operands;  // without result type and result
  LineMark line;
  bool operator==(const Instruction&) const = default;

  std::uint32_t word(std::size_t operand) const {
    REPRISE_CHECK(operand < operands.size() && !operands[operand].words.empty(), static_cast<int>(opcode), operand);
    return operands[operand].words[0];
  }
};

struct Block {
  std::uint32_t label = 0;
  std::vector<Instruction> instructions;  // the last is the terminator
  bool operator==(const Block&) const = default;
  const Instruction& terminator() const { return instructions.back(); }
};

struct Function {
  Instruction definition;               // OpFunction
  std::vector<Instruction> parameters;  // OpFunctionParameter
  std::vector<Block> blocks;            // empty for a declaration; the first is the entry
  bool operator==(const Function&) const = default;
  std::uint32_t id() const { return definition.result_id; }
};

struct Module {
  std::uint32_t version = 0x00010300;
  std::uint32_t bound = 1;  // all ids are below
  std::vector<Instruction> capabilities, extensions, imports, memory_model, entry_points, execution_modes;
  std::vector<Instruction> debug_sources;  // OpString, OpSource...
  std::vector<Instruction> names;          // OpName, OpMemberName
  std::vector<Instruction> processed;      // OpModuleProcessed, which has to follow the names
  std::vector<Instruction> annotations;
  std::vector<Instruction> globals;        // types, constants, global variables
  std::vector<Function> functions;
  bool operator==(const Module&) const = default;

  std::uint32_t freshId() { return bound++; }
};

// Errors (kInput): spirv.invalid with the parser's message; spirv.limit where bound exceeds kMostReadIds, which is what the
// validator takes, too.
inline constexpr std::uint32_t kMostReadIds = 1u << 22;
Result<Module> readModule(std::span<const std::uint32_t> words);
std::vector<std::uint32_t> writeModule(const Module& module);

// Operands for instructions made by transforms.
Operand idOperand(std::uint32_t id);
Operand literalOperand(std::uint32_t word);
Operand stringOperand(const std::string& text);
std::string stringOf(const Operand& operand);

Instruction makeInstruction(spv::Op opcode, std::uint32_t type_id, std::uint32_t result_id,
                            std::vector<Operand> operands);

const Function* findFunction(const Module& module, std::uint32_t id);
Function* findFunction(Module& module, std::uint32_t id);
// The entry point called `name`; the only one where `name` is empty. Null if there is none.
const Instruction* findEntryPoint(const Module& module, const std::string& name);
// OpName of an id, "" where it has none.
std::string nameOf(const Module& module, std::uint32_t id);
// OpMemberName of a struct's member, "" where it has none.
std::string memberNameOf(const Module& module, std::uint32_t type_id, std::uint32_t member);
// The instruction among the globals that defines `id`; null if it is defined elsewhere.
const Instruction* findGlobal(const Module& module, std::uint32_t id);
// First literal of decoration `decoration` on `id`; nullopt if it is not so decorated. 0 where it takes no literal.
std::optional<std::uint32_t> decorationOf(const Module& module, std::uint32_t id, spv::Decoration decoration);
std::optional<std::uint32_t> memberDecorationOf(const Module& module, std::uint32_t type_id, std::uint32_t member,
                                                spv::Decoration decoration);

}  // namespace reprise

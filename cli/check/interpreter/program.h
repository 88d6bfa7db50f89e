// A module as the interpreter reads it: types with their layouts, numbered ids, functions as lists of blocks.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cli/check/interpreter/scalar.h"
#include "runtime/base/result.h"

namespace reprise::interpreter {

inline constexpr std::uint32_t kMostIds = 1u << 22;
inline constexpr std::uint32_t kMostScalars = 1u << 16;  // of one value or variable
inline constexpr std::uint32_t kMostMemory = 1u << 20;   // scalars of all variables, and of all registers, of one run

struct Machine;
struct Instruction;
using Handler = void (*)(Machine&, const Instruction&);

struct Instruction {
  spv::Op op = spv::Op::OpNop;
  std::uint32_t type = 0, result = 0;       // an index of Program::types; an id, 0 where it has none
  std::span<const std::uint32_t> operands;  // without result type and result
  Handler handler = nullptr;                // null: not supported
};

struct Decorations {
  std::optional<std::uint32_t> location, component, index, built_in, set, binding;
  std::uint32_t offset = 0, array_stride = 0, matrix_stride = 0;
  bool row_major = false, block = false;
  std::uint32_t interpolation = 0;  // bits: Flat, NoPerspective, Centroid, Sample
};

enum class Kind {
  kOther, kVoid, kBool, kInt, kFloat, kVector, kMatrix, kArray, kRuntimeArray, kStruct, kPointer, kImage, kSampler, kSampledImage
};

struct Member {
  std::uint32_t type = 0;
  std::uint32_t first = 0;  // scalar of the flattened struct
  Decorations decorations;
};

struct Type {
  Kind kind = Kind::kOther;
  std::uint32_t width = 0;    // of scalars, in bits; of booleans 1
  std::uint32_t element = 0;  // type of components, columns, elements, what a pointer points to
  std::uint32_t count = 0;    // of components, columns, elements
  std::uint32_t flat = 0;     // scalars of a value; kMostScalars + 1 where there are more
  std::uint32_t scalar = 0;   // the scalar type of scalars, vectors and matrices
  std::uint32_t depth = 0;    // of nesting
  std::uint32_t array_stride = 0;
  bool descriptor = false;  // a block, an image or a sampler, or an array of those
  spv::StorageClass storage = spv::StorageClass::Max;
  std::vector<Member> members;
};

struct IdInfo {
  enum class What : std::uint8_t { kNothing, kType, kValue, kLabel, kFunction };
  What what = What::kNothing;
  std::uint32_t type = 0;   // of a value: its type; of a type: itself; indices of Program::types
  std::uint32_t slot = 0;   // of a value: its first register; of a label or function: its index
  std::uint32_t owner = 0;  // 0: global, else 1 + the function's index
  std::uint32_t count = 0;  // registers of a value
};

struct Variable {
  std::uint32_t id = 0, type = 0;  // of what it holds
  std::uint32_t initializer = 0;   // an id, 0 where it has none
  std::uint32_t place = 0;         // first scalar in memory, in a function from the frame's first on
  spv::StorageClass storage = spv::StorageClass::Max;
  Decorations decorations;
};

struct Block {
  std::uint32_t label = 0;
  std::uint32_t number = 0;  // among all blocks of the module
  std::vector<Instruction> instructions;
};

struct Function {
  std::uint32_t id = 0;
  std::vector<std::uint32_t> parameters;  // ids
  std::vector<Variable> variables;
  std::vector<Block> blocks;
  std::uint32_t registers = 0, memory = 0;  // scalars
};

struct Program {
  std::vector<std::uint32_t> words;  // what all operands point into
  std::vector<IdInfo> ids;
  std::vector<Type> types;
  std::vector<Instruction> constants;  // in the order of the module
  std::vector<Variable> variables;     // globals
  std::vector<Function> functions;
  std::unordered_map<std::uint32_t, std::uint32_t> integers;  // constants of 32 bits by id: lengths of arrays
  std::map<std::uint32_t, std::string> imports;  // names of extended instruction sets
  std::vector<std::uint32_t> interface;          // ids that the entry point names
  std::uint32_t entry = 0;                       // index of the function
  std::uint32_t registers = 0, memory = 0;       // scalars of constants and of variables
  std::uint32_t blocks = 0;                      // of all functions
};

// Errors: interpreter.invalid, interpreter.unsupported.
Result<Program> readProgram(std::span<const std::uint32_t> words, const std::string& entry_point);

Error invalid(const std::string& what);
Error unsupported(const std::string& what);
// "OpName" of the instructions that are likely to be told, else "the instruction 123".
std::string nameOfInstruction(spv::Op op);

// The function that executes an instruction; null where there is none.
Handler handlerOf(spv::Op op);
// Of OpExtInst: instruction `number` of a set. One that fails where there is none.
Handler extendedHandler(const std::string& set, std::uint32_t number);

}  // namespace reprise::interpreter

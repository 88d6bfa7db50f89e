// One run of a program: memory, frames and what came of it so far. Handlers of instructions work on it.
//
// A module that breaks the rules makes handlers fail(): what they read then is zeros, and the run ends after the instruction.
#pragma once

#include <unordered_map>

#include "cli/check/interpreter/interpret.h"
#include "cli/check/interpreter/program.h"

namespace reprise::interpreter {

struct Frame {
  std::uint32_t function = 0;
  std::size_t registers = 0, memory = 0;  // where they begin
  std::uint32_t block = 0, next = 0;      // the instruction to come
  std::uint32_t came_from = 0;            // label of the block before
  const Instruction* call = nullptr;      // of the caller; null in the entry point
};

struct Machine {
  Machine(const Program& read, const InterpreterInputs& given);

  // Computes the constants; then the module's variables are made.
  void setUp();
  void run();

  // The scalars of a value; `count` of them are there. Zeros after a failure.
  const Scalar* read(std::uint32_t id, std::uint32_t count);
  // Operand `index` of an instruction; 0 after a failure.
  std::uint32_t word(const Instruction& instruction, std::size_t index);
  const Scalar* operand(const Instruction& instruction, std::size_t index, std::uint32_t count) { return read(word(instruction, index), count); }
  // Of the value that operand `index` names.
  const Type& typeOf(const Instruction& instruction, std::size_t index);
  // The registers of the result; scratch where there are fewer than `count`.
  Scalar* result(const Instruction& instruction, std::uint32_t count);
  const Type& type(const Instruction& instruction) const { return program.types[instruction.type]; }
  const Type& scalarType(const Type& of) const { return program.types[of.scalar]; }

  void fail(Error error) {
    if (!failure) failure = std::move(error);
  }
  bool ended() const { return finished || failure.has_value(); }
  // A branch, an address, a buffer or an image takes a value.
  void decideBy(const Scalar& value) {
    if (value.undefined) reads_undefined = undefined_behaviour = true;
  }
  void misbehave() { reads_undefined = undefined_behaviour = true; }
  // Large values cost more than one step.
  void charge(std::uint64_t scalars) { steps += scalars / 8; }
  // Undefined values of a type.
  void fillUndefined(const Type& type, Scalar* to) const;
  void addEffect(std::uint64_t term);
  // What an operation gives that no value decides: in [0, 1), and 0 to 3; of its hash, and another one at every point and seed.
  double unitOf(std::uint64_t hash) const { return unitFrom(mixed(point, hash)); }
  std::uint64_t smallOf(std::uint64_t hash) const { return mixed(point, ~hash) >> 62; }

  const Program& program;
  const InterpreterInputs& inputs;
  std::vector<Scalar> constants, registers, memory;
  std::vector<Scalar> zeros, scratch;        // as many as the largest value has
  std::vector<Scalar> passed;                // arguments, phis and returned values on their way
  std::vector<Frame> frames;
  std::unordered_map<std::uint64_t, Scalar> stored;         // what was written to buffers, by address
  std::unordered_map<std::uint64_t, std::uint64_t> images;  // what was written to images, by identity
  std::optional<Error> failure;
  Interpretation::Ending ending = Interpretation::Ending::kReturned;
  bool finished = false, helper = false;  // helper: after a demote
  bool reads_undefined = false, undefined_behaviour = false;
  const std::uint64_t point;  // of seed and place
  std::vector<bool> reached;  // blocks by number
  std::uint64_t side_effects = 0, effects = 0, steps = 0;  // effects: how many there were
};

// The value of the constant that gives an array's length. Error: interpreter.invalid.
Result<std::uint64_t> constantLength(const Program& program, std::uint32_t id);

// Calls a function; its arguments are in machine.passed.
void enter(Machine& machine, std::uint32_t function, const Instruction* call);

// Handlers by room; null where the instruction lives elsewhere.
Handler flowHandler(spv::Op op);        // branches, calls, phis, ends
Handler memoryHandler(spv::Op op);      // variables, loads, stores, access chains
Handler compositeHandler(spv::Op op);   // constants, composites, copies, selects
Handler integerHandler(spv::Op op);
Handler floatHandler(spv::Op op);       // arithmetic, comparisons, conversions, matrices, derivatives
Handler imageHandler(spv::Op op);       // samples, queries, image reads and writes
Handler atomicHandler(spv::Op op);

}  // namespace reprise::interpreter

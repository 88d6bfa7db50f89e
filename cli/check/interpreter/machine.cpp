#include "cli/check/interpreter/machine.h"

#include <algorithm>

#include "cli/check/interpreter/interface.h"
#include "cli/check/interpreter/memory.h"

namespace reprise::interpreter {
namespace {

constexpr std::size_t kLeastScratch = 64;  // what handlers take of values whose type they do not look at

}  // namespace

Machine::Machine(const Program& read, const InterpreterInputs& given)
    : program(read), inputs(given),
      point(mixed(mixed(termOf(Term::kMadeUp, given.seed), std::bit_cast<std::uint32_t>(given.frag_x)), std::bit_cast<std::uint32_t>(given.frag_y))) {
  std::size_t largest = kLeastScratch;
  for (const Type& type : program.types)
    if (type.flat <= kMostScalars) largest = std::max<std::size_t>(largest, type.flat);
  zeros.resize(largest);
  reached.resize(program.blocks);
  scratch.resize(largest);
}

void Machine::setUp() {
  constants.assign(program.registers, {});
  for (const Instruction& constant : program.constants) {
    if (constant.handler == nullptr) return fail(unsupported(nameOfInstruction(constant.op)));
    constant.handler(*this, constant);
    if (failure) return;
  }
}

const Scalar* Machine::read(std::uint32_t id, std::uint32_t count) {
  if (id < program.ids.size()) {
    const IdInfo& info = program.ids[id];
    if (info.what == IdInfo::What::kValue && info.count >= count) {
      if (info.owner == 0 && info.slot + count <= constants.size()) return constants.data() + info.slot;
      if (!frames.empty() && info.owner == frames.back().function + 1) return registers.data() + frames.back().registers + info.slot;
    }
  }
  fail(invalid("an instruction reads a value that is not there"));
  REPRISE_CHECK(count <= zeros.size(), count);
  return zeros.data();
}

std::uint32_t Machine::word(const Instruction& instruction, std::size_t index) {
  if (index < instruction.operands.size()) return instruction.operands[index];
  fail(invalid(nameOfInstruction(instruction.op) + " has too few operands"));
  return 0;
}

const Type& Machine::typeOf(const Instruction& instruction, std::size_t index) {
  const std::uint32_t id = word(instruction, index);
  if (id < program.ids.size() && program.ids[id].what == IdInfo::What::kValue) return program.types[program.ids[id].type];
  fail(invalid("an operand is no value"));
  static const Type kNone;
  return kNone;
}

Scalar* Machine::result(const Instruction& instruction, std::uint32_t count) {
  const IdInfo& info = program.ids[instruction.result];
  if (info.what == IdInfo::What::kValue && info.count >= count) {
    if (info.owner == 0) return constants.data() + info.slot;
    if (!frames.empty() && info.owner == frames.back().function + 1) return registers.data() + frames.back().registers + info.slot;
  }
  fail(invalid(nameOfInstruction(instruction.op) + " has a result of another type"));
  return scratch.data();
}

void Machine::fillUndefined(const Type& type, Scalar* to) const {
  if (type.kind == Kind::kStruct) {
    for (const Member& member : type.members) fillUndefined(program.types[member.type], to + member.first);
  } else if (type.kind == Kind::kArray || type.kind == Kind::kMatrix || type.kind == Kind::kVector) {
    const Type& element = program.types[type.element];
    if (element.flat == 0) return;
    fillUndefined(element, to);
    for (std::uint32_t i = element.flat; i < type.flat; ++i) to[i] = to[i - element.flat];
  } else if (type.flat == 1) {
    const std::uint64_t fill = (std::uint64_t{inputs.undefined_fill} << 32) | inputs.undefined_fill;
    to->bits = fill & maskOf(std::max(type.width, 1u));
    to->hash = type.kind == Kind::kFloat ? hashOfBits(to->bits, type.width) : 0;
    to->undefined = true;
    if (type.kind == Kind::kPointer) *to = {};
  }
}

void Machine::addEffect(std::uint64_t term) {
  ++effects;
  side_effects = mixed(mixed(termOf(Term::kEffect, effects), side_effects), term);
}

void Machine::run() {
  setUp();
  if (!failure) setUpMemory(*this);
  if (failure) return;
  const Function& entry = program.functions[program.entry];
  if (!entry.parameters.empty()) return fail(invalid("its entry point has parameters"));
  enter(*this, program.entry, nullptr);
  while (!ended()) {
    Frame& frame = frames.back();
    const std::vector<Instruction>& instructions = program.functions[frame.function].blocks[frame.block].instructions;
    if (frame.next >= instructions.size()) return fail(invalid("a block has no end"));
    const Instruction& instruction = instructions[frame.next++];
    if (++steps > inputs.most_steps) {
      ending = Interpretation::Ending::kEndless;
      return;
    }
    if (instruction.handler == nullptr) return fail(unsupported(nameOfInstruction(instruction.op)));
    instruction.handler(*this, instruction);
  }
}

Result<std::uint64_t> constantLength(const Program& program, std::uint32_t id) {
  const auto literal = program.integers.find(id);
  if (literal != program.integers.end()) return std::max<std::uint64_t>(literal->second, 1);
  // An operation on constants to be specialized.
  const InterpreterInputs none;
  Machine machine(program, none);
  machine.setUp();
  if (machine.failure) return *machine.failure;
  const std::uint64_t length = machine.read(id, 1)->bits;
  if (machine.failure) return *machine.failure;
  if (length == 0) return invalid("an array has no elements");
  return std::min<std::uint64_t>(length, 0xffffffff);
}

}  // namespace reprise::interpreter

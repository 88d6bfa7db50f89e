// Branches, phis, calls and ends.
#include <algorithm>

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

constexpr std::size_t kDeepestCalls = 128;

// All phis of the block read before any is written.
void takePhis(Machine& m, const Block& block) {
  Frame& frame = m.frames.back();
  m.passed.clear();
  std::uint32_t count = 0;
  for (; count < block.instructions.size() && block.instructions[count].op == Op::OpPhi; ++count) {
    const Instruction& phi = block.instructions[count];
    const std::uint32_t size = m.type(phi).flat;
    std::size_t from = 0;
    while (from + 1 < phi.operands.size() && phi.operands[from + 1] != frame.came_from) from += 2;
    if (from + 1 >= phi.operands.size()) return m.fail(invalid("a phi does not name the block before"));
    const Scalar* value = m.read(phi.operands[from], size);
    m.passed.insert(m.passed.end(), value, value + size);
    m.charge(size);
  }
  const Scalar* value = m.passed.data();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t size = m.type(block.instructions[i]).flat;
    std::copy_n(value, size, m.result(block.instructions[i], size));
    value += size;
  }
  frame.next = count;
  m.steps += count;
}

void goTo(Machine& m, std::uint32_t label) {
  Frame& frame = m.frames.back();
  const Function& function = m.program.functions[frame.function];
  if (label >= m.program.ids.size() || m.program.ids[label].what != IdInfo::What::kLabel || m.program.ids[label].owner != frame.function + 1)
    return m.fail(invalid("a branch leads nowhere"));
  frame.came_from = function.blocks[frame.block].label;
  frame.block = m.program.ids[label].slot;
  frame.next = 0;
  const Block& block = function.blocks[frame.block];
  m.reached[block.number] = true;
  if (!block.instructions.empty() && block.instructions[0].op == Op::OpPhi) takePhis(m, block);
}

void branch(Machine& m, const Instruction& i) { goTo(m, m.word(i, 0)); }

void branchConditional(Machine& m, const Instruction& i) {
  const Scalar condition = *m.operand(i, 0, 1);
  m.decideBy(condition);
  goTo(m, m.word(i, condition.bits != 0 ? 1 : 2));
}

void switchOn(Machine& m, const Instruction& i) {
  const Scalar selector = *m.operand(i, 0, 1);
  const Type& type = m.typeOf(i, 0);
  m.decideBy(selector);
  const std::size_t literal = type.width == 64 ? 2 : 1;
  for (std::size_t at = 2; at + literal < i.operands.size(); at += literal + 1) {
    std::uint64_t value = i.operands[at];
    if (literal == 2) value |= std::uint64_t{i.operands[at + 1]} << 32;
    if ((value & maskOf(type.width)) == selector.bits) return goTo(m, i.operands[at + literal]);
  }
  goTo(m, m.word(i, 1));
}

void call(Machine& m, const Instruction& i) {
  const std::uint32_t id = m.word(i, 0);
  if (id >= m.program.ids.size() || m.program.ids[id].what != IdInfo::What::kFunction) return m.fail(invalid("a call of no function"));
  const std::uint32_t number = m.program.ids[id].slot;
  const Function& function = m.program.functions[number];
  if (function.parameters.size() + 1 != i.operands.size()) return m.fail(invalid("a call with another number of arguments"));
  m.passed.clear();
  for (std::size_t p = 0; p < function.parameters.size(); ++p) {
    const std::uint32_t size = m.program.ids[function.parameters[p]].count;
    const Scalar* value = m.operand(i, p + 1, size);
    m.passed.insert(m.passed.end(), value, value + size);
    m.charge(size);
  }
  if (!m.failure) enter(m, number, &i);
}

// m.passed holds what is returned.
void leave(Machine& m) {
  const Frame frame = m.frames.back();
  m.frames.pop_back();
  m.registers.resize(frame.registers);
  m.memory.resize(frame.memory);
  if (frame.call == nullptr) {
    m.finished = true;
    return;
  }
  const std::uint32_t size = m.type(*frame.call).flat;
  if (m.passed.size() < size) return m.fail(invalid("a function returns less than its type"));
  std::copy_n(m.passed.begin(), size, m.result(*frame.call, size));
}

void returnNothing(Machine& m, const Instruction&) {
  m.passed.clear();
  leave(m);
}

void returnValue(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.typeOf(i, 0).flat;
  const Scalar* value = m.operand(i, 0, size);
  m.passed.assign(value, value + size);
  m.charge(size);
  leave(m);
}

void kill(Machine& m, const Instruction&) {
  m.ending = Interpretation::Ending::kDiscarded;
  m.finished = true;
}

void demote(Machine& m, const Instruction&) {
  m.ending = Interpretation::Ending::kDiscarded;
  m.helper = true;
}

void isHelper(Machine& m, const Instruction& i) { *m.result(i, 1) = {m.helper ? 1u : 0u, 0, false}; }

void unreachable(Machine& m, const Instruction&) {
  m.misbehave();
  m.finished = true;
}

void nothing(Machine&, const Instruction&) {}
void strayPhi(Machine& m, const Instruction&) { m.fail(invalid("a phi does not begin its block")); }

}  // namespace

void enter(Machine& m, std::uint32_t number, const Instruction* call) {
  const Function& function = m.program.functions[number];
  if (function.blocks.empty()) return m.fail(unsupported("functions of other modules"));
  Frame frame{number, m.registers.size(), m.memory.size(), 0, 0, 0, call};
  if (m.frames.size() >= kDeepestCalls || frame.registers + function.registers > kMostMemory || frame.memory + function.memory > kMostMemory)
    return m.fail(unsupported("calls nested so deep"));
  m.registers.resize(frame.registers + function.registers);
  m.memory.resize(frame.memory + function.memory);
  m.charge(function.registers + function.memory);
  m.frames.push_back(frame);
  m.reached[function.blocks[0].number] = true;
  const Scalar* value = m.passed.data();
  for (const std::uint32_t parameter : function.parameters) {
    const IdInfo& info = m.program.ids[parameter];
    std::copy_n(value, info.count, m.registers.data() + frame.registers + info.slot);
    value += info.count;
  }
  for (const Variable& variable : function.variables) {
    const Type& type = m.program.types[variable.type];
    Scalar* place = m.memory.data() + frame.memory + variable.place;
    if (variable.initializer != 0) std::copy_n(m.read(variable.initializer, type.flat), type.flat, place);
    else m.fillUndefined(type, place);
    m.registers[frame.registers + m.program.ids[variable.id].slot] = {frame.memory + variable.place, 0, false};
  }
}

Handler flowHandler(Op op) {
  switch (op) {
    case Op::OpPhi: return strayPhi;
    case Op::OpBranch: return branch;
    case Op::OpBranchConditional: return branchConditional;
    case Op::OpSwitch: return switchOn;
    case Op::OpFunctionCall: return call;
    case Op::OpReturn: return returnNothing;
    case Op::OpReturnValue: return returnValue;
    case Op::OpKill: case Op::OpTerminateInvocation: return kill;
    case Op::OpDemoteToHelperInvocationEXT: return demote;
    case Op::OpIsHelperInvocationEXT: return isHelper;
    case Op::OpUnreachable: return unreachable;
    // Other fragments are not there to be waited for.
    case Op::OpMemoryBarrier: case Op::OpBeginInvocationInterlockEXT: case Op::OpEndInvocationInterlockEXT: case Op::OpAssumeTrueKHR:
    case Op::OpModuleProcessed: return nothing;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter

// Atomics: other fragments take part, so what they give is made up, of the place, the operands and how many effects came before.
#include "cli/check/interpreter/memory.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

// A place in an image, as a pointer that only atomics take.
void texelPointer(Machine& m, const Instruction& i) {
  const Pointer image = unpack(*m.operand(i, 0, 1));
  if (image.kind != PointerKind::kDescriptor || image.variable >= m.program.variables.size()) return m.fail(invalid("a texel of no image"));
  Operation op(Term::kTexel, identityOf(m, image));
  for (std::size_t k = 1; k < i.operands.size() && !m.failure; ++k) {
    const Type& type = m.typeOf(i, k);
    op.takeAll(m.operand(i, k, type.flat), type.flat, m.scalarType(type));
  }
  const Scalar undefined = op.givingBoolean(false);
  *m.result(i, 1) = {(std::uint64_t{static_cast<std::uint32_t>(PointerKind::kTexel)} << 62) | (op.hash() >> 2), identityOf(m, image), undefined.undefined};
}

// The place of operand `index`, as something to hash; fails for memory that no other fragment sees.
std::uint64_t placeOf(Machine& m, const Instruction& i, std::size_t index) {
  const Scalar pointer = *m.operand(i, index, 1);
  m.decideBy(pointer);
  const Pointer parts = unpack(pointer);
  if (parts.kind == PointerKind::kTexel) return pointer.bits;
  if (parts.kind != PointerKind::kDescriptor || parts.variable >= m.program.variables.size()) {
    m.fail(unsupported(nameOfInstruction(i.op) + " on variables"));
    return 0;
  }
  return mixed(identityOf(m, parts), parts.offset);
}

bool isTexel(Machine& m, const Instruction& i, std::size_t index) { return unpack(*m.operand(i, index, 1)).kind == PointerKind::kTexel; }

// Reads and writes at once. kFirstValue: the operand after pointer, scope and semantics (of the exchange that compares: two of those).
template <std::size_t kFirstValue>
void modify(Machine& m, const Instruction& i) {
  const std::uint64_t place = placeOf(m, i, 0);
  if (m.failure) return;
  Operation op(i.op);
  op.with(place).with(m.effects);
  for (std::size_t k = kFirstValue; k < i.operands.size() && !m.failure; ++k) {
    const Type& type = m.typeOf(i, k);
    op.take(*m.operand(i, k, 1), m.scalarType(type));
  }
  const Type& type = m.type(i);
  if (type.kind != Kind::kInt && type.kind != Kind::kFloat) return m.fail(invalid("an atomic gives no number"));
  Scalar made = op.givingInteger(0, 1);
  made.hash = op.hash();
  made.bits = type.kind == Kind::kFloat ? bitsOfFloat(m.unitOf(op.hash()), type.width) : m.smallOf(op.hash());
  if (!m.helper) {
    m.decideBy(made);
    m.addEffect(op.hash());
    // What a load finds there later follows from this effect.
    if (isTexel(m, i, 0)) m.images[m.operand(i, 0, 1)->hash] = m.side_effects;
    else store(m, *m.operand(i, 0, 1), type, &made);
  }
  *m.result(i, 1) = made;
}

void atomicLoad(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  if (!isTexel(m, i, 0)) return load(m, *m.operand(i, 0, 1), type, m.result(i, type.flat));
  Operation op(i.op);
  op.with(placeOf(m, i, 0)).with(m.effects);
  const bool is_float = type.kind == Kind::kFloat;
  *m.result(i, 1) = {is_float ? bitsOfFloat(m.unitOf(op.hash()), type.width) : m.smallOf(op.hash()), op.hash(), false};
}

void atomicStore(Machine& m, const Instruction& i) {
  const Type& type = m.typeOf(i, 3);
  const std::uint64_t place = placeOf(m, i, 0);
  if (m.failure || m.helper) return;
  if (!isTexel(m, i, 0)) return store(m, *m.operand(i, 0, 1), type, m.operand(i, 3, type.flat));
  Operation op(i.op);
  op.with(place).take(*m.operand(i, 3, 1), m.scalarType(type));
  m.decideBy(op.givingBoolean(false));
  m.addEffect(op.hash());
  m.images[m.operand(i, 0, 1)->hash] = m.side_effects;
}

}  // namespace

Handler atomicHandler(Op op) {
  switch (op) {
    case Op::OpImageTexelPointer: return texelPointer;
    case Op::OpAtomicLoad: return atomicLoad;
    case Op::OpAtomicStore: return atomicStore;
    case Op::OpAtomicCompareExchange: return modify<4>;
    case Op::OpAtomicExchange: case Op::OpAtomicIIncrement: case Op::OpAtomicIDecrement: case Op::OpAtomicIAdd: case Op::OpAtomicISub:
    case Op::OpAtomicSMin: case Op::OpAtomicUMin: case Op::OpAtomicSMax: case Op::OpAtomicUMax: case Op::OpAtomicAnd:
    case Op::OpAtomicOr: case Op::OpAtomicXor: case Op::OpAtomicFAddEXT: case Op::OpAtomicFMinEXT: case Op::OpAtomicFMaxEXT: return modify<3>;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter

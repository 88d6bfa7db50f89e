// Integers and booleans.
#include <array>
#include <bit>

#include "cli/check/interpreter/componentwise.h"

namespace reprise::interpreter {

using spv::Op;
using U = std::uint64_t;
using S = std::int64_t;

namespace {

U dividedUnsigned(U a, U b) { return b == 0 ? 0 : a / b; }
U remainderUnsigned(U a, U b) { return b == 0 ? 0 : a % b; }
// -1 apart, as the least number by -1 does not fit.
S dividedSigned(S a, S b) { return b == 0 ? 0 : b == -1 ? static_cast<S>(U{0} - static_cast<U>(a)) : a / b; }
S remainderSigned(S a, S b) { return b == 0 || b == -1 ? 0 : a % b; }
S moduloSigned(S a, S b) {
  const S rest = remainderSigned(a, b);
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

// By zero the result is undefined.
template <bool kSigned, auto f>
void divide(Machine& m, const Instruction& i) {
  ofIntegers<2, kSigned, f>(m, i);
  const std::uint32_t size = m.type(i).flat;
  const Scalar* divisor = m.operand(i, 1, size);
  Scalar* to = m.result(i, size);
  for (std::uint32_t c = 0; c < size; ++c)
    if (divisor[c].bits == 0) to[c].undefined = true;
}

template <auto f>
void shift(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const Rows<2> rows(m, i, 0, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const U by = rows.bits(1, c);
    const U value = by >= width ? 0 : f(rows.at[0][c].bits, rows.whole(0, c), static_cast<std::uint32_t>(by));
    to[c] = rows.operation(Operation(i.op), c).givingInteger(value, width);
    if (by >= width) to[c].undefined = true;
  }
}

// A structure of two results: f(a, b, width, low, high).
template <auto f>
void pair(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.typeOf(i, 0).flat;
  const Rows<2> rows(m, i, 0, size);
  const std::uint32_t width = rows.scalar[0]->width;
  if (m.type(i).flat != 2 * size) return m.fail(invalid("an extended result has another type"));
  Scalar* to = m.result(i, 2 * size);
  for (std::uint32_t c = 0; c < size; ++c) {
    U low = 0, high = 0;
    f(rows.at[0][c].bits, rows.at[1][c].bits, width, low, high);
    to[c] = rows.operation(Operation(i.op).with(0), c).givingInteger(low, width);
    to[size + c] = rows.operation(Operation(i.op).with(1), c).givingInteger(high, width);
  }
}

void addCarry(U a, U b, std::uint32_t width, U& low, U& high) {
  low = (a + b) & maskOf(width);
  high = low < a ? 1 : 0;
}
void subBorrow(U a, U b, std::uint32_t width, U& low, U& high) {
  low = (a - b) & maskOf(width);
  high = a < b ? 1 : 0;
}
void multiplyUnsigned(U a, U b, std::uint32_t width, U& low, U& high) {
  // By halves, for those of 64 bits.
  const U a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
  const U middle = a1 * b0 + (a0 * b0 >> 32), other = a0 * b1 + (middle & 0xffffffff);
  low = a * b;
  high = width == 64 ? a1 * b1 + (middle >> 32) + (other >> 32) : low >> width;
}
void multiplySigned(U a, U b, std::uint32_t width, U& low, U& high) {
  multiplyUnsigned(a, b, width, low, high);
  if (signedOf(a, width) < 0) high -= b;
  if (signedOf(b, width) < 0) high -= a;
}

// f(operands of the instruction's first type, offset, count)
template <bool kInsert, bool kSigned>
void bitField(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const std::size_t at = kInsert ? 2 : 1;
  const Scalar *base = m.operand(i, 0, type.flat), *inserted = kInsert ? m.operand(i, 1, type.flat) : base;
  const Scalar *offset = m.operand(i, at, 1), *count = m.operand(i, at + 1, 1);
  Scalar* to = m.result(i, type.flat);
  const bool fits = offset->bits <= width && count->bits <= width && offset->bits + count->bits <= width;
  const std::uint32_t first = fits ? static_cast<std::uint32_t>(offset->bits) : 0, bits = fits ? static_cast<std::uint32_t>(count->bits) : 0;
  const U mask = maskOf(bits);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    U value = base[c].bits;
    if (bits == 0) value = kInsert ? value : 0;
    else if (kInsert) value = (value & ~(mask << first)) | ((inserted[c].bits & mask) << first);
    else value = kSigned ? static_cast<U>(signedOf((value >> first) & mask, bits)) : (value >> first) & mask;
    Operation op(i.op);
    op.take(base[c], m.scalarType(type));
    if (kInsert) op.take(inserted[c], m.scalarType(type));
    op.take(*offset, m.typeOf(i, at)).take(*count, m.typeOf(i, at + 1));
    to[c] = op.givingInteger(value, width);
    if (!fits) to[c].undefined = true;
  }
}

void bitReverse(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const Rows<1> rows(m, i, 0, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    U value = 0;
    for (std::uint32_t bit = 0; bit < width; ++bit) value |= ((rows.bits(0, c) >> bit) & 1) << (width - 1 - bit);
    to[c] = rows.operation(Operation(i.op), c).givingInteger(value, width);
  }
}

// Wider or narrower; as it is where nothing changes.
template <bool kSigned>
void convert(Machine& m, const Instruction& i) {
  integersToInteger<1, kSigned, [](auto a) { return a; }>(m, i, Operation(i.op), 0);
}

template <bool kAll>
void reduce(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.typeOf(i, 0).flat;
  const Scalar* values = m.operand(i, 0, size);
  Scalar out{kAll ? 1u : 0u, 0, false};
  for (std::uint32_t c = 0; c < size; ++c) {
    out.bits = kAll ? out.bits & values[c].bits : out.bits | values[c].bits;
    out.undefined = out.undefined || values[c].undefined;
  }
  *m.result(i, 1) = out;
}

Handler arithmeticHandler(Op op) {
  switch (op) {
    case Op::OpIAdd: return ofIntegers<2, false, [](U a, U b) { return a + b; }>;
    case Op::OpISub: return ofIntegers<2, false, [](U a, U b) { return a - b; }>;
    case Op::OpIMul: return ofIntegers<2, false, [](U a, U b) { return a * b; }>;
    case Op::OpSNegate: return ofIntegers<1, false, [](U a) { return U{0} - a; }>;
    case Op::OpUDiv: return divide<false, dividedUnsigned>;
    case Op::OpSDiv: return divide<true, dividedSigned>;
    case Op::OpUMod: return divide<false, remainderUnsigned>;
    case Op::OpSRem: return divide<true, remainderSigned>;
    case Op::OpSMod: return divide<true, moduloSigned>;
    case Op::OpBitwiseAnd: return ofIntegers<2, false, [](U a, U b) { return a & b; }>;
    case Op::OpBitwiseOr: return ofIntegers<2, false, [](U a, U b) { return a | b; }>;
    case Op::OpBitwiseXor: return ofIntegers<2, false, [](U a, U b) { return a ^ b; }>;
    case Op::OpNot: return ofIntegers<1, false, [](U a) { return ~a; }>;
    case Op::OpBitCount: return ofIntegers<1, false, [](U a) { return static_cast<U>(std::popcount(a)); }>;
    case Op::OpShiftLeftLogical: return shift<[](U a, S, std::uint32_t by) { return a << by; }>;
    case Op::OpShiftRightLogical: return shift<[](U a, S, std::uint32_t by) { return (a >> by); }>;
    case Op::OpShiftRightArithmetic: return shift<[](U, S a, std::uint32_t by) { return static_cast<U>(a >> by); }>;
    case Op::OpIAddCarry: return pair<addCarry>;
    case Op::OpISubBorrow: return pair<subBorrow>;
    case Op::OpUMulExtended: return pair<multiplyUnsigned>;
    case Op::OpSMulExtended: return pair<multiplySigned>;
    case Op::OpBitFieldInsert: return bitField<true, false>;
    case Op::OpBitFieldSExtract: return bitField<false, true>;
    case Op::OpBitFieldUExtract: return bitField<false, false>;
    case Op::OpBitReverse: return bitReverse;
    case Op::OpUConvert: return convert<false>;
    case Op::OpSConvert: return convert<true>;
    default: return nullptr;
  }
}

}  // namespace

Handler integerHandler(Op op) {
  switch (op) {
    case Op::OpIEqual: return testOfIntegers<false, [](U a, U b) { return a == b; }>;
    case Op::OpINotEqual: return testOfIntegers<false, [](U a, U b) { return a != b; }>;
    case Op::OpULessThan: return testOfIntegers<false, [](U a, U b) { return a < b; }>;
    case Op::OpULessThanEqual: return testOfIntegers<false, [](U a, U b) { return a <= b; }>;
    case Op::OpUGreaterThan: return testOfIntegers<false, [](U a, U b) { return b < a; }>;
    case Op::OpUGreaterThanEqual: return testOfIntegers<false, [](U a, U b) { return b <= a; }>;
    case Op::OpSLessThan: return testOfIntegers<true, [](S a, S b) { return a < b; }>;
    case Op::OpSLessThanEqual: return testOfIntegers<true, [](S a, S b) { return a <= b; }>;
    case Op::OpSGreaterThan: return testOfIntegers<true, [](S a, S b) { return b < a; }>;
    case Op::OpSGreaterThanEqual: return testOfIntegers<true, [](S a, S b) { return b <= a; }>;
    case Op::OpLogicalEqual: return testOfIntegers<false, [](U a, U b) { return a == b; }>;
    case Op::OpLogicalNotEqual: return testOfIntegers<false, [](U a, U b) { return a != b; }>;
    case Op::OpLogicalAnd: return testOfIntegers<false, [](U a, U b) { return (a & b) != 0; }>;
    case Op::OpLogicalOr: return testOfIntegers<false, [](U a, U b) { return (a | b) != 0; }>;
    case Op::OpLogicalNot: return ofIntegers<1, false, [](U a) { return a ^ 1; }>;
    case Op::OpAny: return reduce<false>;
    case Op::OpAll: return reduce<true>;
    default: return arithmeticHandler(op);
  }
}

}  // namespace reprise::interpreter

#include "cli/check/interpreter/conversions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/check/interpreter/componentwise.h"

namespace reprise::interpreter {

using spv::Op;

namespace {

// Integers that a float holds exactly are constants: an unrolled loop may have folded them.
template <bool kSigned>
void integerToFloat(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const double exact_below = width == 16 ? 2048.0 : width == 32 ? 16777216.0 : 9007199254740992.0;
  const Rows<1> rows(m, i, 0, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const double value = kSigned ? static_cast<double>(rows.whole(0, c)) : static_cast<double>(rows.bits(0, c));
    to[c] = rows.operation(Operation(i.op), c).giving(value, width);
    if (rows.at[0][c].hash == 0 && std::fabs(value) <= exact_below) to[c].hash = hashOfBits(to[c].bits, width);
  }
}

// Clamped to what the integer holds.
template <bool kSigned>
void floatToInteger(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const double end = std::ldexp(1.0, static_cast<int>(width) - (kSigned ? 1 : 0));
  const Rows<1> rows(m, i, 0, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const double value = std::trunc(rows.number(0, c));
    std::uint64_t bits = 0;
    if (value >= end) bits = maskOf(width - (kSigned ? 1 : 0));
    else if (kSigned && value < -end) bits = std::uint64_t{1} << (width - 1);
    else if (kSigned) bits = std::isnan(value) ? 0 : static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    else bits = value > 0.0 ? static_cast<std::uint64_t>(value) : 0;
    to[c] = rows.operation(Operation(i.op), c).givingInteger(bits, width);
  }
}

// Components of the narrower type are parts of one of the wider, the first the lowest.
void bitcast(Machine& m, const Instruction& i) {
  const Type &type = m.type(i), &from_type = m.typeOf(i, 0);
  const Type &to_scalar = m.scalarType(type), &from_scalar = m.scalarType(from_type);
  const std::uint32_t from_width = from_scalar.width, to_width = to_scalar.width;
  if (from_width < 8 || to_width < 8 || std::uint64_t{from_type.flat} * from_width != std::uint64_t{type.flat} * to_width)
    return m.fail(unsupported("OpBitcast of pointers or between sizes that differ"));
  const Scalar* from = m.operand(i, 0, from_type.flat);
  Scalar* to = m.result(i, type.flat);
  // From signed to unsigned and back moves a value and computes none.
  if (from_width == to_width && from_scalar.kind != Kind::kFloat && to_scalar.kind != Kind::kFloat) {
    std::copy_n(from, type.flat, to);
    return;
  }
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const std::uint32_t first_bit = c * to_width;
    Operation op(i.op);
    std::uint64_t bits = 0;
    bool touched = false, undefined = false;
    for (std::uint32_t bit = first_bit; bit < first_bit + to_width; bit += std::min(from_width, to_width)) {
      const Scalar& part = from[bit / from_width];
      bits |= ((part.bits >> (bit % from_width)) & maskOf(std::min(from_width, to_width))) << (bit - first_bit);
      op.take(part, from_scalar).with(bit % from_width);
      touched = touched || part.hash != 0, undefined = undefined || part.undefined;
    }
    if (to_scalar.kind == Kind::kFloat) to[c] = floatFromBits(bits, to_width, op.hash(), touched, undefined);
    else to[c] = op.givingInteger(bits, to_width);
  }
}

}  // namespace

Scalar floatFromBits(std::uint64_t bits, std::uint32_t width, std::uint64_t computation, bool touched, bool undefined) {
  return {bits, touched ? computation : hashOfBits(bits, width), undefined};
}

Handler conversionHandler(Op op) {
  switch (op) {
    case Op::OpConvertSToF: return integerToFloat<true>;
    case Op::OpConvertUToF: return integerToFloat<false>;
    case Op::OpConvertFToS: return floatToInteger<true>;
    case Op::OpConvertFToU: return floatToInteger<false>;
    case Op::OpBitcast: return bitcast;
    default: return nullptr;
  }
}

}  // namespace reprise::interpreter

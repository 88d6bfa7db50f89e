// GLSL.std.450, component by component; geometry and packing are in files of their own.
#include "cli/check/interpreter/extended.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "cli/check/interpreter/componentwise.h"

namespace reprise::interpreter {

using U = std::uint64_t;
using S = std::int64_t;

namespace {

template <std::size_t kCount, auto f>
void floats(Machine& m, const Instruction& i) {
  floatsToFloat<kCount, f>(m, i, Operation(Term::kExtended, m.word(i, 1)), kFirstExtended);
}

template <std::size_t kCount, bool kSigned, auto f>
void integers(Machine& m, const Instruction& i) {
  integersToInteger<kCount, kSigned, f>(m, i, Operation(Term::kExtended, m.word(i, 1)), kFirstExtended);
}

double sign(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : a; }
double clampNumber(double a, double low, double high) { return std::fmin(std::fmax(a, low), high); }
double smoothStep(double low, double high, double a) {
  const double t = clampNumber((a - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Of the highest bit that differs from the sign.
template <bool kSigned>
void highestBit(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const Rows<1> rows(m, i, kFirstExtended, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    U bits = rows.bits(0, c);
    if (kSigned && rows.whole(0, c) < 0) bits = ~bits & maskOf(rows.scalar[0]->width);
    const U place = bits == 0 ? ~U{0} : static_cast<U>(std::bit_width(bits) - 1);
    to[c] = rows.operation(Operation(Term::kExtended, i.operands[1]), c).givingInteger(place, width);
  }
}

void ldexp(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  const Rows<2> rows(m, i, kFirstExtended, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    const double value = std::ldexp(rows.number(0, c), static_cast<int>(std::clamp<S>(rows.whole(1, c), -10000, 10000)));
    to[c] = rows.operation(Operation(Term::kExtended, i.operands[1]), c).giving(value, m.scalarType(type).width);
  }
}

// Two results of each component, both made by f(value, first, second); `whole`: the second is an integer.
template <bool kWhole, auto f>
void split(Machine& m, const Instruction& i, Scalar* first, Scalar* second, std::uint32_t size, const Type& second_scalar) {
  const Rows<1> rows(m, i, kFirstExtended, size);
  for (std::uint32_t c = 0; c < size; ++c) {
    double a = 0, b = 0;
    f(rows.number(0, c), a, b);
    const Operation op = rows.operation(Operation(Term::kExtended, i.operands[1]), c);
    first[c] = Operation(op).with(0).giving(a, rows.scalar[0]->width);
    Operation other(op);
    other.with(1);
    second[c] = kWhole ? other.givingInteger(static_cast<U>(static_cast<S>(b)), second_scalar.width) : other.giving(b, second_scalar.width);
  }
}

template <bool kWhole, auto f>
void splitToPointer(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  const Type& pointer = m.typeOf(i, kFirstExtended + 1);
  const Type& pointee = m.program.types[pointer.element];
  if (pointer.kind != Kind::kPointer || pointee.flat != size) return m.fail(invalid("the second result has another type"));
  std::array<Scalar, 4> second;
  if (size > second.size()) return m.fail(invalid("a vector of more than four components"));
  split<kWhole, f>(m, i, m.result(i, size), second.data(), size, m.scalarType(pointee));
  if (!m.failure) store(m, *m.operand(i, kFirstExtended + 1, 1), pointee, second.data());
}

template <bool kWhole, auto f>
void splitToStruct(Machine& m, const Instruction& i) {
  const Type& type = m.type(i);
  if (type.kind != Kind::kStruct || type.members.size() != 2) return m.fail(invalid("the result is no structure of two"));
  const Type& second = m.program.types[type.members[1].type];
  const std::uint32_t size = second.flat;
  if (type.flat != 2 * size) return m.fail(invalid("the result is no structure of two"));
  Scalar* to = m.result(i, type.flat);
  split<kWhole, f>(m, i, to, to + size, size, m.scalarType(second));
}

void modf(double value, double& fraction, double& whole) {
  whole = std::trunc(value);
  fraction = std::isinf(value) ? std::copysign(0.0, value) : value - whole;
}
void frexp(double value, double& significand, double& exponent) {
  int power = 0;
  significand = std::frexp(value, &power);
  exponent = std::isfinite(value) ? power : 0;
}

Handler roundingHandler(std::uint32_t number) {
  switch (number) {
    case GLSLstd450Round: case GLSLstd450RoundEven: return floats<1, [](double a) { return std::nearbyint(a); }>;
    case GLSLstd450Trunc: return floats<1, [](double a) { return std::trunc(a); }>;
    case GLSLstd450FAbs: return floats<1, [](double a) { return std::fabs(a); }>;
    case GLSLstd450FSign: return floats<1, sign>;
    case GLSLstd450Floor: return floats<1, [](double a) { return std::floor(a); }>;
    case GLSLstd450Ceil: return floats<1, [](double a) { return std::ceil(a); }>;
    case GLSLstd450Fract: return floats<1, [](double a) { return a - std::floor(a); }>;
    case GLSLstd450FMin: case GLSLstd450NMin: return floats<2, [](double a, double b) { return std::fmin(a, b); }>;
    case GLSLstd450FMax: case GLSLstd450NMax: return floats<2, [](double a, double b) { return std::fmax(a, b); }>;
    case GLSLstd450FClamp: case GLSLstd450NClamp: return floats<3, clampNumber>;
    case GLSLstd450FMix: return floats<3, [](double a, double b, double t) { return a * (1.0 - t) + b * t; }>;
    case GLSLstd450Step: return floats<2, [](double edge, double a) { return a < edge ? 0.0 : 1.0; }>;
    case GLSLstd450SmoothStep: return floats<3, smoothStep>;
    case GLSLstd450Fma: return floats<3, [](double a, double b, double c) { return std::fma(a, b, c); }>;
    case GLSLstd450Ldexp: return ldexp;
    case GLSLstd450Modf: return splitToPointer<false, modf>;
    case GLSLstd450ModfStruct: return splitToStruct<false, modf>;
    case GLSLstd450Frexp: return splitToPointer<true, frexp>;
    case GLSLstd450FrexpStruct: return splitToStruct<true, frexp>;
    default: return nullptr;
  }
}

Handler transcendentalHandler(std::uint32_t number) {
  switch (number) {
    case GLSLstd450Radians: return floats<1, [](double a) { return a * (std::numbers::pi / 180.0); }>;
    case GLSLstd450Degrees: return floats<1, [](double a) { return a * (180.0 / std::numbers::pi); }>;
    case GLSLstd450Sin: return floats<1, [](double a) { return std::sin(a); }>;
    case GLSLstd450Cos: return floats<1, [](double a) { return std::cos(a); }>;
    case GLSLstd450Tan: return floats<1, [](double a) { return std::tan(a); }>;
    case GLSLstd450Asin: return floats<1, [](double a) { return std::asin(a); }>;
    case GLSLstd450Acos: return floats<1, [](double a) { return std::acos(a); }>;
    case GLSLstd450Atan: return floats<1, [](double a) { return std::atan(a); }>;
    case GLSLstd450Sinh: return floats<1, [](double a) { return std::sinh(a); }>;
    case GLSLstd450Cosh: return floats<1, [](double a) { return std::cosh(a); }>;
    case GLSLstd450Tanh: return floats<1, [](double a) { return std::tanh(a); }>;
    case GLSLstd450Asinh: return floats<1, [](double a) { return std::asinh(a); }>;
    case GLSLstd450Acosh: return floats<1, [](double a) { return std::acosh(a); }>;
    case GLSLstd450Atanh: return floats<1, [](double a) { return std::atanh(a); }>;
    case GLSLstd450Atan2: return floats<2, [](double a, double b) { return std::atan2(a, b); }>;
    case GLSLstd450Pow: return floats<2, [](double a, double b) { return std::pow(a, b); }>;
    case GLSLstd450Exp: return floats<1, [](double a) { return std::exp(a); }>;
    case GLSLstd450Log: return floats<1, [](double a) { return std::log(a); }>;
    case GLSLstd450Exp2: return floats<1, [](double a) { return std::exp2(a); }>;
    case GLSLstd450Log2: return floats<1, [](double a) { return std::log2(a); }>;
    case GLSLstd450Sqrt: return floats<1, [](double a) { return std::sqrt(a); }>;
    case GLSLstd450InverseSqrt: return floats<1, [](double a) { return 1.0 / std::sqrt(a); }>;
    default: return nullptr;
  }
}

Handler integerFunctionHandler(std::uint32_t number) {
  switch (number) {
    case GLSLstd450SAbs: return integers<1, true, [](S a) { return a < 0 ? U{0} - static_cast<U>(a) : static_cast<U>(a); }>;
    case GLSLstd450SSign: return integers<1, true, [](S a) { return a == 0 ? S{0} : a < 0 ? S{-1} : S{1}; }>;
    case GLSLstd450UMin: return integers<2, false, [](U a, U b) { return std::min(a, b); }>;
    case GLSLstd450SMin: return integers<2, true, [](S a, S b) { return std::min(a, b); }>;
    case GLSLstd450UMax: return integers<2, false, [](U a, U b) { return std::max(a, b); }>;
    case GLSLstd450SMax: return integers<2, true, [](S a, S b) { return std::max(a, b); }>;
    case GLSLstd450UClamp: return integers<3, false, [](U a, U low, U high) { return std::min(std::max(a, low), high); }>;
    case GLSLstd450SClamp: return integers<3, true, [](S a, S low, S high) { return std::min(std::max(a, low), high); }>;
    case GLSLstd450FindILsb: return integers<1, false, [](U a) { return a == 0 ? ~U{0} : static_cast<U>(std::countr_zero(a)); }>;
    case GLSLstd450FindSMsb: return highestBit<true>;
    case GLSLstd450FindUMsb: return highestBit<false>;
    default: return nullptr;
  }
}

void unknown(Machine& m, const Instruction& i) {
  const auto import = m.program.imports.find(m.word(i, 0));
  const std::string set = import == m.program.imports.end() ? "an unknown set" : import->second;
  m.fail(unsupported("instruction " + std::to_string(m.word(i, 1)) + " of " + set));
}

}  // namespace

Handler extendedHandler(const std::string& set, std::uint32_t number) {
  if (set == "GLSL.std.450")
    for (const auto find : {roundingHandler, transcendentalHandler, integerFunctionHandler, geometryHandler, packingHandler})
      if (const Handler handler = find(number)) return handler;
  return unknown;
}

}  // namespace reprise::interpreter

// Instructions that do the same with every component. Each template makes a handler of a function of numbers.
#pragma once

#include <algorithm>
#include <array>

#include "cli/check/interpreter/machine.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {

// The operands of one instruction: as many components each as the result has (or one part of it).
template <std::size_t kCount>
struct Rows {
  std::array<const Scalar*, kCount> at;
  std::array<const Type*, kCount> scalar;
  std::uint32_t components = 0;

  Rows(Machine& m, const Instruction& i, std::size_t first, std::uint32_t size) : components(size) {
    for (std::size_t k = 0; k < kCount; ++k) {
      scalar[k] = &m.scalarType(m.typeOf(i, first + k));
      at[k] = m.operand(i, first + k, size);
    }
  }

  Operation operation(Operation op, std::uint32_t component) const {
    for (std::size_t k = 0; k < kCount; ++k) op.take(at[k][component], *scalar[k]);
    return op;
  }
  double number(std::size_t k, std::uint32_t component) const { return floatOf(at[k][component].bits, scalar[k]->width); }
  std::uint64_t bits(std::size_t k, std::uint32_t component) const { return at[k][component].bits; }
  std::int64_t whole(std::size_t k, std::uint32_t component) const { return signedOf(at[k][component].bits, scalar[k]->width); }
  bool undefined(std::uint32_t component) const {
    return std::any_of(at.begin(), at.end(), [&](const Scalar* row) { return row[component].undefined; });
  }
};

// f(double...) -> double
template <std::size_t kCount, auto f>
void floatsToFloat(Machine& m, const Instruction& i, Operation op, std::size_t first) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const Rows<kCount> rows(m, i, first, type.flat);
  Scalar* to = m.result(i, type.flat);
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    double value = 0;
    if constexpr (kCount == 1) value = f(rows.number(0, c));
    else if constexpr (kCount == 2) value = f(rows.number(0, c), rows.number(1, c));
    else value = f(rows.number(0, c), rows.number(1, c), rows.number(2, c));
    to[c] = rows.operation(op, c).giving(value, width);
  }
}

template <std::size_t kCount, auto f>
void ofFloats(Machine& m, const Instruction& i) {
  floatsToFloat<kCount, f>(m, i, Operation(i.op), 0);
}

// f(double...) -> bool
template <std::size_t kCount, auto f>
void testOfFloats(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  const Rows<kCount> rows(m, i, 0, size);
  Scalar* to = m.result(i, size);
  for (std::uint32_t c = 0; c < size; ++c) {
    bool value = false;
    if constexpr (kCount == 1) value = f(rows.number(0, c));
    else value = f(rows.number(0, c), rows.number(1, c));
    to[c] = {value ? 1u : 0u, 0, rows.undefined(c)};
  }
}

// f(uint64...) or f(int64...) -> the result's bits; signed where kSigned
template <std::size_t kCount, bool kSigned, auto f>
void integersToInteger(Machine& m, const Instruction& i, Operation op, std::size_t first) {
  const Type& type = m.type(i);
  const std::uint32_t width = m.scalarType(type).width;
  const Rows<kCount> rows(m, i, first, type.flat);
  Scalar* to = m.result(i, type.flat);
  const auto number = [&](std::size_t k, std::uint32_t c) {
    if constexpr (kSigned) return rows.whole(k, c);
    else return rows.bits(k, c);
  };
  for (std::uint32_t c = 0; c < type.flat; ++c) {
    std::uint64_t value = 0;
    if constexpr (kCount == 1) value = static_cast<std::uint64_t>(f(number(0, c)));
    else if constexpr (kCount == 2) value = static_cast<std::uint64_t>(f(number(0, c), number(1, c)));
    else value = static_cast<std::uint64_t>(f(number(0, c), number(1, c), number(2, c)));
    to[c] = rows.operation(op, c).givingInteger(value, width);
  }
}

template <std::size_t kCount, bool kSigned, auto f>
void ofIntegers(Machine& m, const Instruction& i) {
  integersToInteger<kCount, kSigned, f>(m, i, Operation(i.op), 0);
}

template <bool kSigned, auto f>
void testOfIntegers(Machine& m, const Instruction& i) {
  const std::uint32_t size = m.type(i).flat;
  const Rows<2> rows(m, i, 0, size);
  Scalar* to = m.result(i, size);
  for (std::uint32_t c = 0; c < size; ++c) {
    bool value = false;
    if constexpr (kSigned) value = f(rows.whole(0, c), rows.whole(1, c));
    else value = f(rows.bits(0, c), rows.bits(1, c));
    to[c] = {value ? 1u : 0u, 0, rows.undefined(c)};
  }
}

}  // namespace reprise::interpreter

// What of a value goes into the hash of what is computed from it.
#pragma once

#include "cli/check/interpreter/program.h"

namespace reprise::interpreter {

// Of floats their computation, of integers and booleans their bits, with the computation where floats took part.
inline std::uint64_t computationOf(const Scalar& value, const Type& scalar) {
  if (scalar.kind == Kind::kFloat) return value.hash;
  const std::uint64_t bits = hashOfBits(value.bits, scalar.width);
  return value.hash != 0 ? mixed(value.hash, bits) : bits;
}

// An operation that takes up its operands one by one.
class Operation {
 public:
  explicit Operation(spv::Op op) : hash_(termOf(Term::kOperation, static_cast<std::uint64_t>(op))) {}
  Operation(Term kind, std::uint64_t number) : hash_(termOf(kind, number)) {}

  Operation& take(const Scalar& value, const Type& scalar) {
    hash_ = mixed(hash_, computationOf(value, scalar));
    undefined_ = undefined_ || value.undefined;
    touched_ = touched_ || value.hash != 0;
    return *this;
  }
  Operation& takeAll(const Scalar* values, std::uint32_t count, const Type& scalar) {
    for (std::uint32_t i = 0; i < count; ++i) take(values[i], scalar);
    return *this;
  }
  Operation& with(std::uint64_t word) {
    hash_ = mixed(hash_, word);
    return *this;
  }

  std::uint64_t hash() const { return hash_; }
  // A result of this operation. An integer made of integers alone is concrete.
  Scalar giving(double value, std::uint32_t width) const { return {bitsOfFloat(value, width), hash_, undefined_}; }
  Scalar givingInteger(std::uint64_t bits, std::uint32_t width) const { return {bits & maskOf(width), touched_ ? hash_ : 0, undefined_}; }
  Scalar givingBoolean(bool value) const { return {value ? 1u : 0u, 0, undefined_}; }

 private:
  std::uint64_t hash_;
  bool undefined_ = false, touched_ = false;
};

}  // namespace reprise::interpreter

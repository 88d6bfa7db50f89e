// The interpreter's values: every value is a row of scalars, composites flattened in the order of their members.
#pragma once

#include <bit>
#include <cstdint>

namespace reprise::interpreter {

// bits: of integers and floats zero-extended, of booleans 0 or 1, of pointers and images see memory.h.
// hash: of floats the computation; of integers 0, or the computation where floats took part in it; see also memory.h.
struct Scalar {
  std::uint64_t bits = 0, hash = 0;
  bool undefined = false;  // made from an undefined value
};

// Depends on the order: mixed(a, b) is not mixed(b, a).
inline std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = ((std::rotl(hash, 25) + 0x632be59bd9b4e019u) ^ word) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 32)) * 0xd6e8feb86659fd93u;
  return hash ^ (hash >> 29);
}

// What is hashed: kinds of leaves and families of operations, so that they never meet.
enum class Term : std::uint64_t {
  kConstant = 1, kOperation, kExtended, kVarying, kBuiltIn, kBlock, kImage, kTexel, kEffect, kMadeUp
};

inline std::uint64_t termOf(Term kind, std::uint64_t word) { return mixed(static_cast<std::uint64_t>(kind), word); }
inline std::uint64_t hashOfBits(std::uint64_t bits, std::uint32_t width) { return mixed(termOf(Term::kConstant, width), bits); }

inline std::uint64_t maskOf(std::uint32_t width) { return width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1; }
inline std::int64_t signedOf(std::uint64_t bits, std::uint32_t width) {
  if (width == 0 || width >= 64) return static_cast<std::int64_t>(bits);
  return static_cast<std::int64_t>(bits << (64 - width)) >> (64 - width);
}

// Floats of 16, 32 and 64 bits as doubles, which hold them all, and back, rounded to nearest even.
double floatOf(std::uint64_t bits, std::uint32_t width);
std::uint64_t bitsOfFloat(double value, std::uint32_t width);

// [0, 1), from a hash.
double unitFrom(std::uint64_t hash);

}  // namespace reprise::interpreter

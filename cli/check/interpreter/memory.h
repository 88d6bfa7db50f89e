// Pointers and what lies behind them.
//
// A pointer is one scalar. bits: the kind in the highest bits, then the number of the variable, the element of a descriptor array, and
// an offset: a scalar of Machine::memory, or a byte of a buffer. hash: of a pointer into a matrix of a buffer, the stride and the order.
// An image is one scalar, too: bits tell which it is, hash the sampler that it was combined with.
#pragma once

#include "cli/check/interpreter/machine.h"

namespace reprise::interpreter {

enum class PointerKind : std::uint32_t { kMemory = 0, kDescriptor = 1, kTexel = 2 };  // kTexel: the rest is a hash

struct Pointer {
  PointerKind kind = PointerKind::kMemory;
  std::uint32_t variable = 0, element = 0, offset = 0;  // variable: its index in Program::variables
  std::uint32_t matrix_stride = 0, component_stride = 0;  // bytes; component_stride: of a row-major matrix's column, else 0
  bool row_major = false;
};

inline constexpr std::uint32_t kMostVariables = 1u << 13, kMostDescriptors = 1u << 16;

Scalar pack(const Pointer& pointer);
Pointer unpack(const Scalar& scalar);

// What a block or an image is known by: set and binding, or that it is the push constants, and the element.
std::uint64_t identityOf(const Machine& machine, const Pointer& pointer);

// `type` is that of the whole value; a row of type.flat scalars.
void load(Machine& machine, const Scalar& pointer, const Type& type, Scalar* to);
void store(Machine& machine, const Scalar& pointer, const Type& type, const Scalar* from);

// Made-up numbers: of `key` at this run's seed. place: numbers beside each other have others.
double madeUpFloat(const Machine& machine, std::uint64_t key);
std::uint32_t madeUpInt(const Machine& machine, std::uint64_t key, std::uint64_t place);
// In the range of the seed, from one in [0, 1).
double inRangeOfSeed(std::uint32_t seed, double unit);

}  // namespace reprise::interpreter

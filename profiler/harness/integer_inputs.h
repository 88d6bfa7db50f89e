// Integers that a made-up application can be told to give, in place of those that it makes up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/package/interface.h"

namespace reprise {

// One integer of a shader's inputs: a component of a flat varying, or of a block's member. Elements of arrays count as one.
struct IntegerInput {
  enum class Kind { kVarying, kBlock, kPushConstants };
  Kind kind = Kind::kVarying;
  std::uint32_t location = 0, component = 0;  // of a varying
  std::uint32_t set = 0, binding = 0;         // of a block
  std::vector<std::uint32_t> offsets;         // in bytes, of the elements in the block
  bool operator==(const IntegerInput&) const = default;
};

struct IntegerValue {
  IntegerInput input;
  std::uint32_t value = 0;  // element i of an array gets (value + i) modulo kIntegerValues
  bool operator==(const IntegerValue&) const = default;
};

using IntegerAssignment = std::vector<IntegerValue>;

inline constexpr std::uint32_t kIntegerValues = 4;  // 0, 1, 2, 3

// The integers in the bytes [first, end) of a block: one for each component of a member, whatever the indices in its name.
std::vector<IntegerInput> integersIn(const std::vector<BlockMember>& members, std::uint32_t first_byte, std::uint32_t end_byte);

// Rows of assignments in which every two of the inputs show every pair of the values 0, 1, 2, 3 (covering_array.h).
std::vector<IntegerAssignment> coveringAssignments(std::span<const IntegerInput> inputs, std::size_t most_rows);

// Writes what the assignment says of a block; values stay below `below`.
void putIntegers(const IntegerAssignment& assignment, const Descriptor& block, std::uint32_t below, std::span<std::byte> bytes);
void putPushedIntegers(const IntegerAssignment& assignment, std::uint32_t below, std::span<std::byte> bytes);

}  // namespace reprise

// Seeded contents for blocks and texels: varied, finite and tame enough to index and to loop with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/package/interface.h"

namespace reprise {

// A sequence of pseudo-random numbers; the same for the same seed.
class MadeUpValues {
 public:
  explicit MadeUpValues(std::uint32_t seed) : state_(seed * 0x9e3779b9u + 0x7f4a7c15u) {}
  std::uint32_t bits();
  float fraction();             // [0, 1)
  std::uint32_t below(std::uint32_t count) { return bits() % count; }

 private:
  std::uint32_t state_;
};

// `size_bytes` of a block: members by their type, what no member tells as floats in [0, 1).
std::vector<std::byte> madeUpBlock(const std::vector<BlockMember>& members, std::size_t size_bytes, MadeUpValues& values);

}  // namespace reprise

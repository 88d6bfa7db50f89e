// Seeded contents for blocks and texels: varied, finite and tame enough to index and to loop with.
//
// The seed also chooses their style, one of four in turn, as a shader may show nothing for one of them: floats in [0, 1) with
// integers in 0..3, floats in [-1, 1) with integers in 0..1, floats in [0, 8) with integers in 0..7, and floats in [0, 2) with
// integers in 0..15.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/package/interface.h"

namespace reprise {

enum class MadeUpStyle : std::uint32_t { kFractions, kSigned, kLarge, kCounts };
MadeUpStyle styleOf(std::uint32_t seed);

// A sequence of pseudo-random numbers; the same for the same seed.
class MadeUpValues {
 public:
  // Integers stay below `below`, which is at least 1: they may be indices into what has no more elements.
  explicit MadeUpValues(std::uint32_t seed, std::uint32_t below = kAnyInteger)
      : state_(seed * 0x9e3779b9u + 0x7f4a7c15u), style_(styleOf(seed)), below_(below) {}
  MadeUpStyle style() const { return style_; }
  std::uint32_t bits();
  float fraction();             // [0, 1)
  std::uint32_t below(std::uint32_t count) { return bits() % count; }
  float number();               // in the style's range
  std::uint32_t whole();        // in the style's range

  static constexpr std::uint32_t kAnyInteger = 0xffffffffu;

 private:
  std::uint32_t state_;
  MadeUpStyle style_;
  std::uint32_t below_;
};

// Made-up integers may index arrays of descriptors, whose elements alone are there: all stay below the length of the shortest.
std::uint32_t integerLimit(const ShaderInterface& interface);

// `size_bytes` of a block: members by their type, what no member tells as floats.
std::vector<std::byte> madeUpBlock(const std::vector<BlockMember>& members, std::size_t size_bytes, MadeUpValues& values);

// The block some frames later: floats drift a little from frame to frame, matrices and integers stay. Frame 0 is the block itself.
std::vector<std::byte> blockAtFrame(const std::vector<BlockMember>& members, const std::vector<std::byte>& block, int frame);

}  // namespace reprise

// The group formulas that are part of the format; compiler/strategies/glsl/refresh.glsl computes the same.
#include <algorithm>
#include <bit>

#include "runtime/package/recipe.h"

namespace reprise {
namespace {

std::uint32_t hashBlock(std::uint32_t x, std::uint32_t y) {
  std::uint32_t hash = (x * 0x8da6b343u) ^ (y * 0xd8163841u);
  hash ^= hash >> 16;
  hash *= 0x7feb352du;
  hash ^= hash >> 15;
  hash *= 0x846ca68bu;
  hash ^= hash >> 16;
  return hash;
}

}  // namespace

std::uint32_t refreshGroup(PatternKind kind, std::uint32_t x, std::uint32_t y, std::uint32_t period_frames,
                           std::uint32_t block, std::uint32_t width, std::uint32_t height) {
  REPRISE_CHECK(std::has_single_bit(period_frames) && std::has_single_bit(block) && block >= 2 && width > 0 && height > 0, period_frames, block,
                width, height);
  const std::uint32_t block_x = x / block, block_y = y / block;
  if (kind == PatternKind::kRandom) return hashBlock(block_x, block_y) & (period_frames - 1);
  const int bits = std::countr_zero(period_frames);
  const int columns_shift = (bits + 1) / 2;
  const std::uint32_t columns = 1u << columns_shift, rows = period_frames >> columns_shift;
  if (kind == PatternKind::kInterleaved) return (block_x & (columns - 1)) + ((block_y & (rows - 1)) << columns_shift);
  const auto roundedUp = [](std::uint32_t a, std::uint32_t b) { return (a + b - 1) / b; };
  const std::uint32_t tile_x = roundedUp(roundedUp(width, block), columns), tile_y = roundedUp(roundedUp(height, block), rows);
  return std::min(block_x / tile_x, columns - 1) + (std::min(block_y / tile_y, rows - 1) << columns_shift);
}

}  // namespace reprise

// The group formulas that are part of the format, and the form in which compiler/strategies/glsl/refresh.glsl tests them.
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

constexpr std::uint32_t kNoBound = 0xffffffffu;

std::uint32_t roundedUp(std::uint32_t a, std::uint32_t b) { return (a + b - 1) / b; }

// Groups lie in columns x rows, as square as powers of two can be.
struct GroupGrid {
  std::uint32_t columns_shift = 0, columns = 1, rows = 1;
  explicit GroupGrid(std::uint32_t period_frames)
      : columns_shift(static_cast<std::uint32_t>(std::countr_zero(period_frames) + 1) / 2), columns(1u << columns_shift),
        rows(period_frames >> columns_shift) {}
};

struct TileSize {
  std::uint32_t x = 1, y = 1;  // in blocks
  TileSize(const GroupGrid& grid, std::uint32_t block, std::uint32_t width, std::uint32_t height)
      : x(roundedUp(roundedUp(width, block), grid.columns)), y(roundedUp(roundedUp(height, block), grid.rows)) {}
};

}  // namespace

std::uint32_t refreshGroup(PatternKind kind, std::uint32_t x, std::uint32_t y, std::uint32_t period_frames,
                           std::uint32_t block, std::uint32_t width, std::uint32_t height) {
  REPRISE_CHECK(std::has_single_bit(period_frames) && std::has_single_bit(block) && block >= 2 && width > 0 && height > 0, period_frames, block,
                width, height);
  const std::uint32_t block_x = x / block, block_y = y / block;
  if (kind == PatternKind::kWhole) return 0;
  if (kind == PatternKind::kRandom) return hashBlock(block_x, block_y) & (period_frames - 1);
  const GroupGrid grid(period_frames);
  if (kind == PatternKind::kInterleaved) return (block_x & (grid.columns - 1)) + ((block_y & (grid.rows - 1)) << grid.columns_shift);
  const TileSize tile(grid, block, width, height);
  return std::min(block_x / tile.x, grid.columns - 1) + (std::min(block_y / tile.y, grid.rows - 1) << grid.columns_shift);
}

bool isWhollyDue(const Refresh& refresh, std::uint32_t frame) {
  return refresh.pattern == PatternKind::kWhole && refresh.period_frames != kNeverRefresh && frame % refresh.period_frames == 0;
}

bool drawsIn(const Pass& pass, bool wholly_due) {
  return pass.frames == PassFrames::kAll || wholly_due == (pass.frames == PassFrames::kWhollyDue);
}

DueBlocks dueBlocks(const Refresh& refresh, std::uint32_t frame, std::uint32_t width, std::uint32_t height) {
  if (refresh.period_frames == kNeverRefresh) return refresh.pattern == PatternKind::kTiled ? DueBlocks{{0, 0, 0, 0}} : DueBlocks{};
  REPRISE_CHECK(std::has_single_bit(refresh.period_frames), refresh.period_frames);
  if (refresh.pattern == PatternKind::kWhole) return {{isWhollyDue(refresh, frame) ? 1u : 0u, 0, 0, 0}};
  const std::uint32_t turn = frame & (refresh.period_frames - 1);
  if (refresh.pattern == PatternKind::kRandom) return {{refresh.period_frames - 1, turn, 0, 0}};
  const GroupGrid grid(refresh.period_frames);
  const std::uint32_t column = turn & (grid.columns - 1), row = turn >> grid.columns_shift;
  if (refresh.pattern == PatternKind::kInterleaved) return {{(grid.columns - 1) | (grid.rows - 1) << 16, column | row << 16, 0, 0}};
  const TileSize tile(grid, refresh.block_pixels, std::max(width, 1u), std::max(height, 1u));
  const std::uint32_t tile_width = tile.x * refresh.block_pixels, tile_height = tile.y * refresh.block_pixels;
  // The last tiles reach to the end, whatever is left over.
  return {{column * tile_width, row * tile_height, column + 1 == grid.columns ? kNoBound : (column + 1) * tile_width,
           row + 1 == grid.rows ? kNoBound : (row + 1) * tile_height}};
}

bool isDue(const DueBlocks& due, const Refresh& refresh, std::uint32_t x, std::uint32_t y) {
  const auto& word = due.words;
  if (refresh.pattern == PatternKind::kWhole) return word[0] != 0;
  if (refresh.pattern == PatternKind::kTiled) return x >= word[0] && y >= word[1] && x < word[2] && y < word[3];
  const std::uint32_t block_x = x / refresh.block_pixels, block_y = y / refresh.block_pixels;
  const std::uint32_t key = refresh.pattern == PatternKind::kRandom ? hashBlock(block_x, block_y) : block_x | block_y << 16;
  return (key & word[0]) == word[1];
}

}  // namespace reprise

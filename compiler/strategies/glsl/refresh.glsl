// When a pixel's payload is due to be computed again: refreshGroup() of runtime/package/recipe.h.
uint repriseGroup(uvec2 pixel, uint period) {
  uvec2 block = pixel >> BLOCK_SHIFT;
#if PATTERN == PATTERN_RANDOM
  uint hash = block.x * 0x8da6b343u ^ block.y * 0xd8163841u;
  hash ^= hash >> 16;
  hash *= 0x7feb352du;
  hash ^= hash >> 15;
  hash *= 0x846ca68bu;
  hash ^= hash >> 16;
  return hash & (period - 1u);
#else
  uint columns_shift = reprise.columns_shift;
  uint columns = 1u << columns_shift;
  uint rows = period >> columns_shift;
#if PATTERN == PATTERN_INTERLEAVED
  return (block.x & (columns - 1u)) + ((block.y & (rows - 1u)) << columns_shift);
#else
  uvec2 extent = uvec2(abs(reprise.viewport.zw));
  uvec2 blocks = (extent + ((1u << BLOCK_SHIFT) - 1u)) >> BLOCK_SHIFT;
  uvec2 tile = (blocks + uvec2(columns, rows) - 1u) / uvec2(columns, rows);
  uvec2 at = min(block / tile, uvec2(columns, rows) - 1u);
  return at.x + (at.y << columns_shift);
#endif
#endif
}

bool repriseDue() {
  uint group = repriseGroup(uvec2(gl_FragCoord.xy), reprise.period_frames);
  uint turn = reprise.frame & (reprise.period_frames - 1u);
  bool ever = reprise.period_frames != 0u;
  bool turns = group == turn;
  return ever && turns;
}

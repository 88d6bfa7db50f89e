// When a pixel's payload is due to be computed again: isDue() of runtime/package/recipe.h.
bool repriseDue() {
#if PATTERN == PATTERN_WHOLE
  return reprise.due.x != 0u;
#else
  uvec2 pixel = uvec2(gl_FragCoord.xy);
#if PATTERN == PATTERN_TILED
  bvec2 from = greaterThanEqual(pixel, reprise.due.xy);
  bvec2 to = lessThan(pixel, reprise.due.zw);
  bool past_from = all(from);
  bool before_to = all(to);
  return past_from && before_to;
#else
  uvec2 block = pixel >> BLOCK_SHIFT;
#if PATTERN == PATTERN_RANDOM
  uint key = block.x * 0x8da6b343u ^ block.y * 0xd8163841u;
  key ^= key >> 16;
  key *= 0x7feb352du;
  key ^= key >> 15;
  key *= 0x846ca68bu;
  key ^= key >> 16;
#else
  uint key = block.x | block.y << 16;
#endif
  return (key & reprise.due.x) == reprise.due.y;
#endif
#endif
}

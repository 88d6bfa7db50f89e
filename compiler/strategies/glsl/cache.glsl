// Conditions are computed one by one and joined afterwards: && of anything but variables is a branch in SPIR-V, and branches
// cost more than comparisons where both sides run under a mask.
//
// How payload and depth lie in the history: encode, store, decode.
//
// Depth is view-linear (clip w, or z for orthographic cameras), mapped to [1/16, 1]; 0 is "nothing valid here".
// DEPTH_RANGE, PAYLOAD_SCALE, ...: struct CacheConstants of runtime/package/recipe.h.
// PAYLOAD_VEC: vec4, or uvec4 for INTEGER payloads, which are kept bit by bit in an image of their own.
// NARROW: the last target has one channel of payload and the depth beside it, in a two-channel format.
// STORES: the pass writes a history; else what a store or a carried texel would write is not computed.
#if STORES
#if TARGETS > 1
layout(location = CACHE_LOCATION) out PAYLOAD_VEC reprise_full_cache[TARGETS - 1];
#endif
#if NARROW
layout(location = CACHE_LOCATION + TARGETS - 1) out vec2 reprise_cache;
#else
layout(location = CACHE_LOCATION + TARGETS - 1) out PAYLOAD_VEC reprise_cache;
#endif
#if !DEPTH_IN_ALPHA
layout(location = CACHE_LOCATION + TARGETS) out float reprise_cache_depth;
#endif
#endif

float repriseStoredDepth(float depth) { return depth * DEPTH_RANGE.x + DEPTH_RANGE.y; }

float repriseViewDepth() {
#if ORTHOGRAPHIC
  return FRAG_COORD.z;
#else
  return 1.0 / FRAG_COORD.w;
#endif
}

// False for NaN and infinity too. Only the channels that the payload has count.
bool repriseStorable(PAYLOAD_VEC encoded[TARGETS]) {
#if INTEGER
  return true;
#else
  vec2 range = PAYLOAD_RANGE.xy;
  vec4 last = encoded[TARGETS - 1];
#if LAST_CHANNELS == 1
  bool high_enough = last.x >= range.x;
  bool low_enough = last.x <= range.y;
#elif LAST_CHANNELS == 2
  bool high_enough = all(greaterThanEqual(last.xy, range.xx));
  bool low_enough = all(lessThanEqual(last.xy, range.yy));
#elif LAST_CHANNELS == 3
  bool high_enough = all(greaterThanEqual(last.xyz, range.xxx));
  bool low_enough = all(lessThanEqual(last.xyz, range.yyy));
#else
  bool high_enough = all(greaterThanEqual(last, range.xxxx));
  bool low_enough = all(lessThanEqual(last, range.yyyy));
#endif
  bool storable = high_enough && low_enough;
#if TARGETS > 1
  for (int target = 0; target < TARGETS - 1; ++target) {
    high_enough = all(greaterThanEqual(encoded[target], range.xxxx));
    low_enough = all(lessThanEqual(encoded[target], range.yyyy));
    storable = storable && high_enough;
    storable = storable && low_enough;
  }
#endif
  return storable;
#endif
}

void repriseEncode(PAYLOAD_VEC payload[TARGETS], out PAYLOAD_VEC encoded[TARGETS]) {
#if AFFINE
  const vec4 scale[TARGETS] = PAYLOAD_SCALE;
  const vec4 offset[TARGETS] = PAYLOAD_OFFSET;
#define ENCODE(target) encoded[target] = payload[target] * scale[target] + offset[target];
  EACH_TARGET(ENCODE)
#else
  encoded = payload;
#endif
}

#if STORES
void repriseWrite(PAYLOAD_VEC encoded[TARGETS], float depth) {
#if TARGETS > 1
  for (int target = 0; target < TARGETS - 1; ++target) reprise_full_cache[target] = encoded[target];
#endif
  PAYLOAD_VEC last = encoded[TARGETS - 1];
#if NARROW
  reprise_cache = vec2(last.x, depth);
#elif DEPTH_IN_ALPHA
  reprise_cache = vec4(last.rgb, depth);
#else
  reprise_cache = last;
  reprise_cache_depth = depth;
#endif
}
#else
void repriseWrite(PAYLOAD_VEC encoded[TARGETS], float depth) {}
#endif

// The depth to keep beside a payload: 0, "nothing valid here", where it lies outside the range that the format resolves.
float repriseKeptDepth() {
  float depth = repriseStoredDepth(repriseViewDepth());
  bool in_range = depth == clamp(depth, DEPTH_RANGE.z, DEPTH_RANGE.w);
  return in_range ? depth : 0.0;
}

// A payload computed now. KEEP_RAW: a later pass of this frame reads the payload back, so it is stored even where it is not fit
// to be reused.
void repriseStore(PAYLOAD_VEC payload[TARGETS]) {
  PAYLOAD_VEC encoded[TARGETS];
  repriseEncode(payload, encoded);
  bool storable = repriseStorable(encoded);
#if !KEEP_RAW
#define CLEAR(target) encoded[target] = storable ? encoded[target] : PAYLOAD_VEC(0);
  EACH_TARGET(CLEAR)
#endif
  repriseWrite(encoded, storable ? repriseKeptDepth() : 0.0);
}

// A hit's texel goes on as it was fetched: it was fit to be stored once, and encoding it anew could only round it out of range.
void repriseCarry(PAYLOAD_VEC texel[TARGETS]) { repriseWrite(texel, repriseKeptDepth()); }

// Conditions are computed one by one and joined afterwards: && of anything but variables is a branch in SPIR-V, and branches
// cost more than comparisons where both sides run under a mask.
//
// How payload and depth lie in the history: encode, store, decode.
//
// Depth is view-linear (clip w, or z for orthographic cameras), mapped to [1/16, 1]; 0 is "nothing valid here".
// DEPTH_RANGE, PAYLOAD_SCALE, ...: struct CacheConstants of runtime/package/recipe.h.
// PAYLOAD_VEC: vec4, or uvec4 for INTEGER payloads, which are kept bit by bit in an image of their own.
// NARROW: one channel of payload and the depth beside it, in a two-channel format.
#if NARROW
layout(location = CACHE_LOCATION) out vec2 reprise_cache;
#else
layout(location = CACHE_LOCATION) out PAYLOAD_VEC reprise_cache;
#endif
#if !DEPTH_IN_ALPHA
layout(location = CACHE_LOCATION + 1) out float reprise_cache_depth;
#endif

float repriseStoredDepth(float depth) { return depth * DEPTH_RANGE.x + DEPTH_RANGE.y; }

float repriseViewDepth() {
#if ORTHOGRAPHIC
  return gl_FragCoord.z;
#else
  return 1.0 / gl_FragCoord.w;
#endif
}

// False for NaN and infinity too. Only the channels that the payload has count.
bool repriseStorable(PAYLOAD_VEC encoded) {
#if INTEGER
  return true;
#else
  vec2 range = PAYLOAD_RANGE.xy;
#if CHANNELS == 1
  bool high_enough = encoded.x >= range.x;
  bool low_enough = encoded.x <= range.y;
#elif CHANNELS == 2
  bool high_enough = all(greaterThanEqual(encoded.xy, range.xx));
  bool low_enough = all(lessThanEqual(encoded.xy, range.yy));
#elif CHANNELS == 3
  bool high_enough = all(greaterThanEqual(encoded.xyz, range.xxx));
  bool low_enough = all(lessThanEqual(encoded.xyz, range.yyy));
#else
  bool high_enough = all(greaterThanEqual(encoded, range.xxxx));
  bool low_enough = all(lessThanEqual(encoded, range.yyyy));
#endif
  return high_enough && low_enough;
#endif
}

PAYLOAD_VEC repriseEncode(PAYLOAD_VEC payload) {
#if AFFINE
  return payload * PAYLOAD_SCALE + PAYLOAD_OFFSET;
#else
  return payload;
#endif
}

PAYLOAD_VEC repriseDecode(PAYLOAD_VEC encoded) {
#if AFFINE
  return (encoded - PAYLOAD_OFFSET) * (1.0 / PAYLOAD_SCALE);
#else
  return encoded;
#endif
}

void repriseWrite(PAYLOAD_VEC encoded, float depth) {
#if NARROW
  reprise_cache = vec2(encoded.x, depth);
#elif DEPTH_IN_ALPHA
  reprise_cache = vec4(encoded.rgb, depth);
#else
  reprise_cache = encoded;
  reprise_cache_depth = depth;
#endif
}

// The depth to keep beside a payload: 0, "nothing valid here", where it lies outside the range that the format resolves.
float repriseKeptDepth() {
  float depth = repriseStoredDepth(repriseViewDepth());
  bool in_range = depth == clamp(depth, DEPTH_RANGE.z, DEPTH_RANGE.w);
  return in_range ? depth : 0.0;
}

// A payload computed now. KEEP_RAW: a later pass of this frame reads the payload back, so it is stored even where it is not fit
// to be reused.
void repriseStore(PAYLOAD_VEC payload, bool valid) {
  PAYLOAD_VEC encoded = repriseEncode(payload);
  bool storable = repriseStorable(encoded);
  valid = valid && storable;
#if !KEEP_RAW
  encoded = valid ? encoded : PAYLOAD_VEC(0);
#endif
  repriseWrite(encoded, valid ? repriseKeptDepth() : 0.0);
}

// A hit's texel goes on as it was fetched: it was fit to be stored once, and encoding it anew could only round it out of range.
void repriseCarry(PAYLOAD_VEC texel) { repriseWrite(texel, repriseKeptDepth()); }

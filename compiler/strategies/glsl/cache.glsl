// How payload and depth lie in the history: encode, store, decode.
//
// Depth is view-linear (clip w, or z for orthographic cameras), mapped to [1/16, 1]; 0 is "nothing valid here".
layout(location = CACHE_LOCATION) out vec4 reprise_cache;
#if !DEPTH_IN_ALPHA
layout(location = CACHE_LOCATION + 1) out float reprise_cache_depth;
#endif

float repriseStoredDepth(float depth) { return depth * reprise.depth_range.x + reprise.depth_range.y; }

float repriseViewDepth() {
#if ORTHOGRAPHIC
  return gl_FragCoord.z;
#else
  return 1.0 / gl_FragCoord.w;
#endif
}

// False for NaN and infinity too. Only the channels that the payload has count.
bool repriseStorable(vec4 encoded) {
  vec2 range = reprise.payload_range.xy;
  bool storable = encoded.x >= range.x && encoded.x <= range.y;
#if CHANNELS > 1
  storable = storable && encoded.y >= range.x && encoded.y <= range.y;
#endif
#if CHANNELS > 2
  storable = storable && encoded.z >= range.x && encoded.z <= range.y;
#endif
#if CHANNELS > 3
  storable = storable && encoded.w >= range.x && encoded.w <= range.y;
#endif
  return storable;
}

vec4 repriseEncode(vec4 payload) {
#if AFFINE
  return payload * reprise.payload_scale + reprise.payload_offset;
#else
  return payload;
#endif
}

vec4 repriseDecode(vec4 encoded) {
#if AFFINE
  return (encoded - reprise.payload_offset) / reprise.payload_scale;
#else
  return encoded;
#endif
}

// KEEP_RAW: a later pass of this frame reads the payload back, so it is stored even where it is not fit to be reused.
void repriseStore(vec4 payload, bool valid) {
  vec4 encoded = repriseEncode(payload);
  float depth = repriseStoredDepth(repriseViewDepth());
  valid = valid && repriseStorable(encoded) && depth >= reprise.depth_range.z && depth <= reprise.depth_range.w;
#if !KEEP_RAW
  encoded = valid ? encoded : vec4(0.0);
#endif
  depth = valid ? depth : 0.0;
#if DEPTH_IN_ALPHA
  reprise_cache = vec4(encoded.rgb, depth);
#else
  reprise_cache = encoded;
  reprise_cache_depth = depth;
#endif
}

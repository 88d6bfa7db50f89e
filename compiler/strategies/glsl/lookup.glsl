// The lookup: reproject, test visibility, fetch (Nehab et al. 2007, sections 3.1-3.3).
//
// Where the fragment's surface point was in the last frame comes from the vertex side in pixels of that frame, homogeneous: (x w,
// y w, w), or (x, y, z) for orthographic cameras. The history is filtered by the sampler in unnormalized coordinates, payload
// and depth alike: a footprint across a depth edge gives a depth that matches no surface, hence a miss. So does what lies
// outside the image, where the sampler's border is 0, and what lies outside the viewport, where nothing was drawn.
layout(location = PREVIOUS_LOCATION) in vec3 reprise_previous;
#if !DEPTH_IN_ALPHA
layout(set = REPRISE_SET, binding = 2 + TARGETS) uniform sampler2D reprise_history_depth;
#endif
#if AGE_BINDING
layout(set = REPRISE_SET, binding = AGE_BINDING) uniform sampler2D reprise_history_age;
#endif

// texel: what the history holds, encoded; meaningless for a miss.
// A hit has every guarded value that the pixel needs, from all of its taps (GUARDS_HOLD: by guards, which are 0 or 1 before filtering).
bool repriseLookup(out PAYLOAD_VEC texel[TARGETS]) {
  float depth = reprise_previous.z;
#if ORTHOGRAPHIC
  vec2 at = reprise_previous.xy;
#else
  vec2 at = reprise_previous.xy * (1.0 / depth);
#endif
#if BILINEAR
  // A point that did not move must fetch its own texel and no other (frozen world, no error); nearest does so by itself.
  vec2 centre = floor(at) + 0.5;
  vec2 off = abs(at - centre);
  at = max(off.x, off.y) < 1.0 / 512.0 ? centre : at;
#endif

  float expected = repriseStoredDepth(depth);
  float slope = min((abs(dFdx(expected)) + abs(dFdy(expected))) * TOLERANCE.y, TOLERANCE.w);
  float tolerance = TOLERANCE.x + slope + TOLERANCE.z * expected;

  repriseFetch(at, texel);
#if AGE_BINDING
  // What is mixed of several texels has the age of the nearest.
  reprise_age_of_hit = min(textureLod(reprise_history_age, at, 0.0).g + 1.0, 255.0);
#endif
#if NARROW
  float stored = texel[TARGETS - 1].g;
#elif DEPTH_IN_ALPHA
  float stored = texel[TARGETS - 1].a;
#else
  float stored = textureLod(reprise_history_depth, at, 0.0).r;
#endif
  bool hit = abs(stored - expected) <= tolerance;
  bool fresh = !repriseDue();
  hit = hit && fresh;
#if !ORTHOGRAPHIC
  bool in_front = depth > 0.0;
  hit = hit && in_front;
#endif
#if KEEP_RAW
  bool storable = repriseStorable(texel);
  hit = hit && storable;
#endif
#if GUARDED
  reprise_wanted = 0u;
  reprise_wants();
  bool guarded = GUARDS_HOLD;
  hit = hit && guarded;
#endif
#if POISONED
  // For tests: hits get what no shader computed, and keep their depth. Integers stay near: they may bound a loop.
  PAYLOAD_VEC clean = texel[TARGETS - 1];
#if INTEGER
#define POISON(target) texel[target] ^= 1u;
#else
#define POISON(target) texel[target] = texel[target] * -3.0 + 7.5;
#endif
  EACH_TARGET(POISON)
#if NARROW
  texel[TARGETS - 1].g = clean.g;
#elif DEPTH_IN_ALPHA
  texel[TARGETS - 1].a = clean.a;
#endif
#endif
  return hit;
}

// What misses left (keep.glsl), taken up again. The shader's inputs are variables here.
KEPT_TAKEN
vec4 reprise_frag_coord;
bool reprise_front_facing;
layout(set = REPRISE_SET, binding = 2) uniform usampler2D reprise_kept0;
#if KEPT_TARGETS > 1
layout(set = REPRISE_SET, binding = 3) uniform usampler2D reprise_kept1;
#endif
#if KEPT_TARGETS > 2
layout(set = REPRISE_SET, binding = 4) uniform usampler2D reprise_kept2;
#endif
#if KEPT_TARGETS > 3
layout(set = REPRISE_SET, binding = 5) uniform usampler2D reprise_kept3;
#endif
#if KEPT_TARGETS > 4
layout(set = REPRISE_SET, binding = 6) uniform usampler2D reprise_kept4;
#endif
#if KEPT_TARGETS > 5
layout(set = REPRISE_SET, binding = 7) uniform usampler2D reprise_kept5;
#endif

// False where there is nothing to repair.
bool repriseTake() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec4 words[KEPT_TARGETS];
  words[0] = texelFetch(reprise_kept0, pixel, 0);
  if (words[0].x == 0u) return false;
#if KEPT_TARGETS > 1
  words[1] = texelFetch(reprise_kept1, pixel, 0);
#endif
#if KEPT_TARGETS > 2
  words[2] = texelFetch(reprise_kept2, pixel, 0);
#endif
#if KEPT_TARGETS > 3
  words[3] = texelFetch(reprise_kept3, pixel, 0);
#endif
#if KEPT_TARGETS > 4
  words[4] = texelFetch(reprise_kept4, pixel, 0);
#endif
#if KEPT_TARGETS > 5
  words[5] = texelFetch(reprise_kept5, pixel, 0);
#endif
  TAKE
  return true;
}

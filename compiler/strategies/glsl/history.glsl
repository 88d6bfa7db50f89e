// A history's images, one for each target of the payload, and a depth image where depth is in none of them.
layout(set = REPRISE_SET, binding = 2) uniform PAYLOAD_SAMPLER reprise_history0;
#if TARGETS > 1
layout(set = REPRISE_SET, binding = 3) uniform PAYLOAD_SAMPLER reprise_history1;
#endif
#if TARGETS > 2
layout(set = REPRISE_SET, binding = 4) uniform PAYLOAD_SAMPLER reprise_history2;
#endif
#if TARGETS > 3
layout(set = REPRISE_SET, binding = 5) uniform PAYLOAD_SAMPLER reprise_history3;
#endif

void repriseFetch(vec2 at, out PAYLOAD_VEC texel[TARGETS]) {
  texel[0] = textureLod(reprise_history0, at, 0.0);
#if TARGETS > 1
  texel[1] = textureLod(reprise_history1, at, 0.0);
#endif
#if TARGETS > 2
  texel[2] = textureLod(reprise_history2, at, 0.0);
#endif
#if TARGETS > 3
  texel[3] = textureLod(reprise_history3, at, 0.0);
#endif
}

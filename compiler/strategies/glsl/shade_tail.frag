// Three passes: the last, which reads this frame's payload at its own pixel and runs the tail for hits and misses alike.
#include "frame_uniforms.glsl"
#include "body.glsl"
layout(set = REPRISE_SET, binding = 2) uniform PAYLOAD_SAMPLER reprise_now;

void main() {
  PAYLOAD_VEC encoded = textureLod(reprise_now, gl_FragCoord.xy, 0.0);
#if AFFINE
  encoded = (encoded - PAYLOAD_OFFSET) * (1.0 / PAYLOAD_SCALE);
#endif
  reprise_payload = encoded;
  reprise_hit();
}

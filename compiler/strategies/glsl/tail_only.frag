// The limit: the tail alone with a payload that costs nothing. No variant of the payload can be faster.
#include "frame_uniforms.glsl"
#include "body.glsl"

void main() {
  for (int target = 0; target < TARGETS; ++target) {
#if SIGNED
    reprise_payload[target] = PAYLOAD_VEC(ivec4(reprise.free_payload[target]));
#else
    reprise_payload[target] = PAYLOAD_VEC(reprise.free_payload[target]);
#endif
  }
  reprise_hit();
}

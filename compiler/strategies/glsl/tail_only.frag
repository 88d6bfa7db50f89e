// The limit: the tail alone with a payload that costs nothing. No variant of the payload can be faster.
#include "frame_uniforms.glsl"
#include "body.glsl"

void main() {
#if SIGNED
  reprise_payload = PAYLOAD_VEC(ivec4(reprise.free_payload));
#else
  reprise_payload = PAYLOAD_VEC(reprise.free_payload);
#endif
  reprise_hit();
}

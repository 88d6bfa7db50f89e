// Three passes: the last, which reads this frame's payload at its own pixel and runs the tail for hits and misses alike.
#include "frame_uniforms.glsl"
#include "decode.glsl"
#include "history.glsl"
#include "body.glsl"

void main() {
  PAYLOAD_VEC encoded[TARGETS];
  repriseFetch(gl_FragCoord.xy, encoded);
  repriseDecode(encoded, reprise_payload);
  reprise_hit();
}

// One pass: look up, then run the one or the other (Nehab et al. 2007, section 3.4).
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "cache.glsl"
#include "lookup.glsl"
#include "body.glsl"
#include "count.glsl"

void main() {
  vec4 payload;
  bool hit = repriseLookup(payload);
  reprise_payload_valid = hit ? 1u : 0u;
  reprise_payload = hit ? payload : vec4(0.0);
  if (hit) {
    reprise_hit();
  } else {
    reprise_miss();
  }
  repriseStore(reprise_payload, reprise_payload_valid != 0u);
  repriseCount(hit);
}

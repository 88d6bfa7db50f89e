// One pass: look up, then run the one or the other (Nehab et al. 2007, section 3.4).
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "cache.glsl"
#include "lookup.glsl"
#include "body.glsl"
#include "count.glsl"

void main() {
  PAYLOAD_VEC texel;
  bool hit = repriseLookup(texel);
  reprise_payload_valid = 0u;
  reprise_payload = hit ? repriseDecode(texel) : PAYLOAD_VEC(0);
  if (hit) {
    reprise_hit();
    repriseCarry(texel);
  } else {
    reprise_miss();
    repriseStore(reprise_payload, reprise_payload_valid != 0u);
  }
  repriseCount(hit);
}

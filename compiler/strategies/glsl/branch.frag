// One pass: look up, then run the one or the other (Nehab et al. 2007, section 3.4).
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "decode.glsl"
#include "cache.glsl"
#include "history.glsl"
#include "body.glsl"
#include "age.glsl"
#include "lookup.glsl"
#if TAKES_DERIVATIVES
#include "quad.glsl"
#endif
#include "count.glsl"

void main() {
  PAYLOAD_VEC texel[TARGETS];
  bool hit = repriseLookup(texel);
#if TAKES_DERIVATIVES
  // One miss makes the quad miss.
  bool miss = !hit;
  hit = !repriseAnyOfQuad(miss);
#endif
  if (hit) {
    repriseDecode(texel, reprise_payload);
    reprise_hit();
    repriseCarry(texel);
  } else {
    reprise_payload = PAYLOAD_INITIAL;
    reprise_miss();
    repriseStore(reprise_payload);
  }
  repriseCount(hit);
}

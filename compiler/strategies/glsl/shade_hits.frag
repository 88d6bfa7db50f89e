// Of several passes, the one that shades the hits and leaves the misses to the next, which depth or stencil lets through.
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "decode.glsl"
#include "cache.glsl"
#include "history.glsl"
#include "body.glsl"
#include "lookup.glsl"
#include "count.glsl"
#include "flag_draw.glsl"

void main() {
  PAYLOAD_VEC texel[TARGETS];
  if (!repriseLookup(texel)) {
    repriseFlagDraw();
    discard;
  }
  repriseDecode(texel, reprise_payload);
  reprise_hit();
  repriseCarry(texel);
  repriseCount(true);
}

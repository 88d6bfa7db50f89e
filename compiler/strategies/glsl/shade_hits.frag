// Of several passes, the one that shades the hits and leaves the misses to the next, which depth or stencil lets through.
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "cache.glsl"
#include "lookup.glsl"
#include "body.glsl"
#include "count.glsl"

void main() {
  PAYLOAD_VEC texel;
  if (!repriseLookup(texel)) discard;
  reprise_payload = repriseDecode(texel);
  reprise_hit();
  repriseCarry(texel);
  repriseCount(true);
}

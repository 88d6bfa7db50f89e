// Of several passes, the one that shades the hits and leaves the misses to the next, which depth or stencil lets through.
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "cache.glsl"
#include "lookup.glsl"
#include "body.glsl"
#include "count.glsl"

void main() {
  vec4 payload;
  if (!repriseLookup(payload)) discard;
  reprise_payload = payload;
  reprise_hit();
  repriseStore(payload, true);
  repriseCount(true);
}

// Of several passes, the one that shades what the hits left: the whole shader, or its slice where colours are hidden.
#include "frame_uniforms.glsl"
#include "cache.glsl"
#include "body.glsl"
#include "count.glsl"

void main() {
  reprise_payload_valid = 0u;
  reprise_payload = PAYLOAD_VEC(0);
  reprise_miss();
  repriseStore(reprise_payload, reprise_payload_valid != 0u);
  repriseCount(false);
}

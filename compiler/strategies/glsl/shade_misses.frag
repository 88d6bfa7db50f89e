// Of several passes, the one that shades what the hits left: the whole shader, or its slice where colours are hidden.
#include "frame_uniforms.glsl"
#include "decode.glsl"
#include "cache.glsl"
#include "body.glsl"
#include "age.glsl"
#include "count.glsl"

void main() {
  reprise_payload = PAYLOAD_INITIAL;
  reprise_miss();
  repriseStore(reprise_payload);
  repriseCount(false);
}

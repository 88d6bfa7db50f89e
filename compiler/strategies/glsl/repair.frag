// The pass that repairs: the whole shader for the misses of flagged tiles.
#include "frame_uniforms.glsl"
#include "decode.glsl"
#include "kept.glsl"
#include "cache.glsl"
#include "body.glsl"
#include "age.glsl"
#include "count.glsl"

void main() {
  if (!repriseTake()) discard;
  reprise_payload = PAYLOAD_INITIAL;
  reprise_miss();
  repriseStore(reprise_payload);
  repriseCount(false);
}

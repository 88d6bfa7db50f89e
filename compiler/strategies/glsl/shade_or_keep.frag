// The one draw of a strategy that repairs: hits are shaded, misses leave what the repair needs. Fragments that something hides later may
// flag a tile in vain, but what they leave is written over.
#include "frame_uniforms.glsl"
#include "refresh.glsl"
#include "decode.glsl"
#include "cache.glsl"
#include "history.glsl"
#include "body.glsl"
#include "age.glsl"
#include "lookup.glsl"
#include "count.glsl"
#include "keep.glsl"

layout(early_fragment_tests) in;

void main() {
  PAYLOAD_VEC texel[TARGETS];
  bool hit = repriseLookup(texel);
  if (hit) {
    repriseDecode(texel, reprise_payload);
    reprise_hit();
    repriseCarry(texel);
    repriseKeepNothing();
    repriseCount(true);
  } else {
    repriseKeep();
    repriseCountNothing();
  }
}

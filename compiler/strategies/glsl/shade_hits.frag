// Of several passes, the one that shades the hits and leaves the misses to the next, which depth or stencil lets through.
//
// Where the shader takes derivatives a miss goes along as far as a hit beside it needs it: what a tail takes derivatives of does not depend on
// the payload, so its lane gives the right ones whatever it fetched.
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
#include "flag_draw.glsl"

void main() {
  PAYLOAD_VEC texel[TARGETS];
  bool hit = repriseLookup(texel);
#if TAKES_DERIVATIVES
  bool goes_on = repriseAnyOfQuad(hit);
#else
  bool goes_on = hit;
#endif
  if (!hit) repriseFlagDraw();
  if (!goes_on) discard;
  repriseDecode(texel, reprise_payload);
  reprise_hit();
  repriseCarry(texel);
  repriseCount(true);
#if TAKES_DERIVATIVES
  if (!hit) discard;
#endif
}

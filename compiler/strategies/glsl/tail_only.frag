// The limit: the tail alone with a payload that costs nothing. No variant of the payload can be faster.
#include "frame_uniforms.glsl"
#include "body.glsl"

void main() {
  reprise_payload = reprise.free_payload;
  reprise_hit();
}

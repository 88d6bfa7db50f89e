// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = place;
  float gain = 1.0;
  if (place.x > 0.1) {
    base = marble(place);
    gain = waves(base.x);
  } else if (place.y > 0.2) {
    base = marble(place.zxy) * 0.5;
  }
  vec3 later = marble(base) * gain;
  color = vec4(place.z > 0.0 ? later : later.zyx, gain);
}

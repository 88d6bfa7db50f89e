// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  float sum = 0.0, step_length = 0.3 + 0.5 * abs(base.x);
  for (float at = 0.0; at < 2.0; at += step_length) sum += waves(at + place.y);
  color = vec4(base + 0.2 * sum, 1.0);
}

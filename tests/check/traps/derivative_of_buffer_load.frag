// expect: verified
// The same number for the whole draw: its derivative is 0, also beside pixels that were not drawn.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(std430, set = 0, binding = 0) readonly buffer Numbers { vec4 head; float list[]; } numbers;
void main() {
  vec3 base = marble(place) * (1.0 + waves(place.y));
  float same = numbers.list[2] + 1.0;
  color = vec4(base + abs(dFdx(same)) + abs(dFdy(same)) + 0.1 * numbers.head.xyz, 1.0);
}

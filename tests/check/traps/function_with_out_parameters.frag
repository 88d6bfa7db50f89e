// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void split(in vec3 p, out vec3 base, inout float sum, out bool dark) {
  base = marble(p);
  sum += waves(p.x);
  dark = base.x < 0.2;
}
float global_sum = 0.0;
void main() {
  vec3 base;
  bool dark;
  split(place, base, global_sum, dark);
  if (dark) split(base, base, global_sum, dark);
  color = vec4(base, global_sum);
}

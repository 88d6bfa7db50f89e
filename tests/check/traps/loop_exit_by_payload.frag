// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  int count = int(4.0 * abs(base.y)) + 1;
  for (int i = 0; i < count; ++i) base = base.yzx * 0.9 + 0.1 * sin(base * 3.0);
  color = vec4(base, 1.0);
}

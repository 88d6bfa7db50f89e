// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  color = vec4(0.0, 0.0, 0.0, 1.0);
  vec3 q = place;
  for (int i = 0; i < 6; ++i) {
    q += 0.15 * marble(q);
    if (length(q) > 1.1) {
      color.xyz = marble(q) * float(i + 1);
      return;
    }
  }
  color.xyz = sin(q * 2.0);
}

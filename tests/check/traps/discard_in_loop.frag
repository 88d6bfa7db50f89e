// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 q = place;
  for (int i = 0; i < 5; ++i) {
    q += 0.1 * sin(q.yzx * 6.0);
    if (q.x > 0.9) discard;
  }
  color = vec4(marble(q), 1.0);
}

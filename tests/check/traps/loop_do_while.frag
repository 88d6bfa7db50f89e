// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { ivec4 counts; } light;
void main() {
  vec3 q = place;
  int steps = 0;
  do {
    q = q.yzx * 0.8 + 0.3 * sin(q * 4.0);
    ++steps;
  } while (steps < light.counts.x + 3);
  color = vec4(marble(q) + 0.05 * float(steps), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  color = vec4(marble(place), 0.0);
  for (int i = 0; i < 4; ++i) {
    color.xyz = color.yzx * 0.8 + 0.2 * sin(place * float(i + 2));
    color.w += 0.25;
  }
}

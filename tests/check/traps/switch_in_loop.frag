// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  for (int i = 0; i < 5; ++i) {
    switch ((i + int(place.x * 2.0 + 4.0)) % 3) {
      case 0: base = base.yzx * 0.9; continue;
      case 1: base += 0.1 * sin(base * 5.0); break;
      default: base *= 1.05;
    }
    base += 0.02;
  }
  color = vec4(base, 1.0);
}

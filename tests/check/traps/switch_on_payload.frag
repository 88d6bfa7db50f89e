// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  int kind = int(fract(base.x * 7.0) * 3.0);
  float sum = 0.0;
  switch (kind) {
    case 0: sum = waves(place.x); break;
    case 1: sum = waves(place.y) * base.z; break;
    default: sum = place.z;
  }
  color = vec4(base + sum, float(kind));
}

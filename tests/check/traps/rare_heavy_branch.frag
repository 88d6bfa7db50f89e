// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = sin(place * 4.0);
  if (fract(place.x * 2.0) < 0.15) {
    base += marble(place);
    base *= waves(base.x) + waves(base.y);
    base += marble(base.yzx);
  }
  color = vec4(base, 1.0);
}

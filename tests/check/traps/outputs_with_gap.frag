// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 3) out vec4 other;
void main() {
  vec3 base = marble(place);
  color = vec4(base * waves(place.x), 1.0);
  other = vec4(base.zxy, place.x);
}

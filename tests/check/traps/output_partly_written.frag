// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  color.xy = base.xy;
  color.z = waves(place.x);
  color.w = 1.0;
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 targets[3];
void main() {
  vec3 base = marble(place);
  targets[0] = vec4(base, 1.0);
  targets[1] = vec4(base * waves(place.x), 0.5);
  targets[2] = vec4(place, base.x);
}

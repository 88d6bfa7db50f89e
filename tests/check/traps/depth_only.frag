// expect: refused output.none
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
void main() {
  if (marble(place).x > 0.4) discard;
}

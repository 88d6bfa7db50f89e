// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(interpolateAtCentroid(place));
  color = vec4(base * waves(interpolateAtOffset(uv, vec2(0.2)).x), 1.0);
}

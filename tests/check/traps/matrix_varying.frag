// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) in mat3 frame;
void main() {
  vec3 base = marble(place);
  vec3 normal = normalize(frame * (base - 0.5));
  color = vec4(base * (0.5 + 0.5 * normal), waves(frame[1].x));
}

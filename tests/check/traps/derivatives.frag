// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  float height = waves(place.x) * waves(place.z);
  vec3 normal = normalize(vec3(dFdx(height), dFdy(height), 0.1));
  vec3 base = marble(place);
  color = vec4(base * (0.5 + 0.5 * normal.z) + fwidth(uv.x), 1.0);
}

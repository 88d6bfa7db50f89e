// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  ivec3 cell = ivec3(floor(place * 9.0));
  uint bits = uint(cell.x * 73856093 ^ cell.y * 19349663 ^ cell.z * 83492791);
  bits = (bits ^ bits >> 16) * 0x7feb352du;
  bits = (bits ^ bits >> 15) * 0x846ca68bu;
  bits ^= bits >> 16;
  color = vec4(unpackUnorm4x8(bits).xyz * place, float(bits & 7u));
}

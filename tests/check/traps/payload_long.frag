// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
void main() {
  uint64_t state = uint64_t(uint(place.x * 64.0 + 128.0)) * 6364136223846793005UL + 1442695040888963407UL;
  state ^= state >> 33;
  state *= 0xff51afd7ed558ccdUL;
  float noise = float(uint(state >> 40)) / 16777216.0;
  color = vec4(marble(place) * noise, 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
const vec2 kOffsets[4] = vec2[](vec2(0.1, 0.7), vec2(-0.4, 0.2), vec2(0.5, -0.3), vec2(-0.2, -0.6));
void main() {
  vec3 base = marble(place);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 4; ++i) sum += kOffsets[i] * waves(place.x + kOffsets[3 - i].y);
  color = vec4(base + kOffsets[int(base.x * 3.0) & 3].xyx + sum.x, 1.0);
}

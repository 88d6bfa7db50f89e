// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

void main() {
  float table[6];
  for (int i = 0; i < 6; ++i) table[i] = waves(place.x + 0.4 * float(i));
  vec3 base = marble(place);
  int at = int(abs(base.x) * 5.9) % 6;
  table[at] += base.y;
  color = vec4(base * table[(at + light.counts.x) % 6] + table[at], 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

void main() {
  vec3 base = marble(place);
  float sum = 0.0, last = 0.0;
  for (int i = 0; i < 8; ++i) {
    last = waves(place.x + 0.2 * float(i));
    if (last < 0.0) continue;
    if (i > light.counts.z + 1 && last > 0.6) break;
    sum += last * base.x;
  }
  color = vec4(base * sum + last, 1.0);
}

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
  float sum = waves(place.y);
  switch (int(place.x * 4.0 + 8.0) % 4) {
    case 0: sum += waves(base.x);
    case 1: sum *= waves(base.y); break;
    case 2: color = vec4(base, sum); return;
    case 3: sum = cos(sum);
    default: sum -= light.tint.x;
  }
  color = vec4(base * sum, 1.0);
}

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
  float sum = 0.0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < light.counts.y + y; ++x) {
      if (x == 2 && base.x > 0.3) break;
      sum += waves(place.x + float(x) * 0.3 + float(y));
    }
  color = vec4(base * cos(sum), 1.0);
}

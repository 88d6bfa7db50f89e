// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  float sum = 0.0;
  for (int i = 0; i < 5; ++i) sum += waves(place.x * float(i + 1));
  color = vec4(base * (0.5 + 0.1 * sum), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
float pick(float x) {
  if (x < -0.2) return waves(x);
  for (int i = 0; i < 4; ++i)
    if (waves(x + float(i)) > 0.7) return float(i) * waves(x * 2.0);
  return cos(x);
}
void main() { color = vec4(marble(place) * pick(place.x) + pick(place.y), 1.0); }

// expect: verified
// Undefined where the pixels of a quad take different ways: told, and left out of the comparison.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place) * (1.0 + waves(place.y));
  float edge = 0.0;
  if (fract(uv.x * 9.0) > 0.5) edge = 20.0 * (abs(dFdx(uv.y * place.x)) + abs(dFdy(place.x)));
  color = vec4(base + edge, 1.0);
}

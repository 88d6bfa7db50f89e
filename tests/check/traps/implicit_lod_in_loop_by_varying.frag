// expect: verified
// Pixels of a quad leave the loop one after the other, and those that stay sample on.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D height_map;
void main() {
  vec3 base = marble(place);
  float height = 0.0;
  for (int i = 0; i < 12; ++i) {
    if (height > fract(7.0 * uv.x + 3.0 * uv.y)) break;
    height += 0.3 * texture(height_map, uv * (2.0 + float(i)) + 0.1 * height).x + 0.05;
  }
  color = vec4(base * waves(place.x) + height * 0.1, 1.0);
}

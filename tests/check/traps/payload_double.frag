// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  dvec2 z = dvec2(place.xy), c = dvec2(uv);
  for (int i = 0; i < 5; ++i) z = dvec2(z.x * z.x - z.y * z.y, 2.0lf * z.x * z.y) * 0.5lf + c * 0.3lf;
  vec3 base = marble(vec3(z, place.z));
  color = vec4(base * float(z.x), 1.0);
}

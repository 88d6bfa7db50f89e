// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
vec3 shade(vec3 p, int depth) {
  vec3 q = marble(p);
  if (depth > 0 && q.x > 0.3) return q * waves(p.x);
  return q.zyx;
}
vec3 twice(vec3 p) { return shade(p, 0) + shade(p.yzx, 1); }
void main() { color = vec4(twice(place) + shade(place.zxy, 2), 1.0); }

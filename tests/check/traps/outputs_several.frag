// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) out vec2 normal_target;
layout(location = 2) out float gloss;
void main() {
  vec3 base = marble(place);
  color = vec4(base, 1.0);
  normal_target = vec2(waves(place.x), waves(place.y));
  gloss = dot(base, vec3(0.3)) + normal_target.x;
}

// expect: refused shader.subgroup
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_vote : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  if (subgroupAny(base.x > 0.3)) base *= waves(place.x);
  color = vec4(base, 1.0);
}

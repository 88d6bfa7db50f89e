// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_demote_to_helper_invocation : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 1) uniform sampler2D albedo;

void main() {
  vec3 base = marble(place);
  if (base.y > 0.4) demote;
  vec2 slope = dFdx(uv) + dFdy(uv);
  color = vec4(base * texture(albedo, uv + slope).xyz, 1.0);
}

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
  if (sin(place.x * 20.0) > 0.3) demote;
  vec3 base = marble(place);
  color = vec4(texture(albedo, uv * 3.0).xyz * base + fwidth(place.x), 1.0);
}

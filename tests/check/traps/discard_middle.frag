// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 1) uniform sampler2D albedo;

void main() {
  vec3 base = marble(place);
  if (base.x > 0.35) discard;
  color = vec4(base * texture(albedo, uv * 2.0).xyz * waves(place.y), 1.0);
}

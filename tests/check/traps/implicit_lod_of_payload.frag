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
  vec2 at = uv + 0.1 * base.xy;
  color = vec4(texture(albedo, at).xyz * waves(base.z) + texture(albedo, at * 3.0, 1.0).xyz, 1.0);
}

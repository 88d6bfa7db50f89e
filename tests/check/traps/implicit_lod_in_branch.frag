// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;
layout(set = 0, binding = 1) uniform sampler2D albedo;

void main() {
  vec3 base = marble(place);
  if (light.tint.x > 0.1) base *= texture(albedo, uv * 4.0).xyz;
  if (base.x > 0.2) base += texture(albedo, uv.yx * 7.0).zyx * waves(place.x);
  color = vec4(base, 1.0);
}

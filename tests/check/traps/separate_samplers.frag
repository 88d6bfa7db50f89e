// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 1, binding = 0) uniform texture2D picture;
layout(set = 1, binding = 1) uniform sampler smooth_sampler;
layout(set = 1, binding = 2) uniform texture2D sheets[2];
void main() {
  vec3 base = marble(place) * texture(sampler2D(picture, smooth_sampler), uv).xyz;
  color = vec4(base + texture(sampler2D(sheets[1], smooth_sampler), uv.yx).zyx * waves(place.x), 1.0);
}

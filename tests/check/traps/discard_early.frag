// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 1) uniform sampler2D albedo;

void main() {
  if (texture(albedo, uv).x < 0.4) discard;
  color = vec4(marble(place) * waves(place.x), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform First { vec4 tint; } first;
layout(set = 0, binding = 0) uniform Second { vec4 tint; mat4 turn; } second;
layout(set = 0, binding = 1) uniform sampler2D one;
layout(set = 0, binding = 1) uniform sampler2D other;
void main() {
  vec3 base = marble(place) * first.tint.xyz * (texture(one, uv) + texture(other, uv.yx)).xyz;
  color = vec4(base + (second.turn * vec4(place, 1.0)).xyz * waves(place.x), 1.0);
}

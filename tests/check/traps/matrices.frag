// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

void main() {
  vec3 base = marble(place);
  mat3 turn = mat3(cos(place.x), sin(place.x), 0.0, -sin(place.x), cos(place.x), 0.0, 0.0, 0.0, 1.0);
  mat3 both = turn * mat3(base, light.tint.xyz, place);
  color = vec4(inverse(both + 3.0 * mat3(1.0)) * base * determinant(both) + transpose(both)[1], 1.0);
}

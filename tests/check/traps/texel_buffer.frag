// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform samplerBuffer table;
layout(set = 0, binding = 1) uniform usamplerBuffer indices;
void main() {
  vec3 base = marble(place);
  uint at = texelFetch(indices, int(abs(place.x) * 40.0)).y;
  color = vec4(base + texelFetch(table, int(at) + int(base.x * 9.0)).xyz * waves(place.y), 1.0);
}

// expect: refused shader.side_effects
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, r32ui) uniform uimage2D counts;
void main() {
  vec3 base = marble(place);
  imageAtomicMax(counts, ivec2(gl_FragCoord.xy), uint(base.x * 9.0));
  color = vec4(base, 1.0);
}

// expect: refused shader.side_effects
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) buffer Log { uint count; } log_block;
void main() {
  vec3 base = marble(place);
  uint mine = atomicAdd(log_block.count, 1u);
  color = vec4(base * float(mine & 1u), 1.0);
}

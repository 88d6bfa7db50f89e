// expect: refused shader.side_effects
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) buffer Log { float last; } log_block;
void main() {
  vec3 base = marble(place);
  if (base.x > 0.4) log_block.last = base.y;
  color = vec4(base, 1.0);
}

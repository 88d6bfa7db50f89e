// expect: refused shader.side_effects
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, std430) buffer Log { vec4 entries[8]; } log_block;
void note(int at, vec4 value) { log_block.entries[at & 7] = value; }
void main() {
  vec3 base = marble(place);
  for (int i = 0; i < 3; ++i) note(i, vec4(base, float(i)));
  color = vec4(base * waves(place.x), 1.0);
}

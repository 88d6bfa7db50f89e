// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 1) out uvec2 ids;
layout(location = 2) out int step_count;
void main() {
  vec3 base = marble(place);
  color = vec4(base, 1.0);
  ids = uvec2(base.xy * 255.0) << 2u;
  step_count = int(waves(place.x) * 100.0) - 7;
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  float edge = smoothstep(0.0, fwidth(base.x) * 2.0, abs(base.x - 0.3));
  color = vec4(mix(vec3(waves(place.x)), base, edge), 1.0);
}

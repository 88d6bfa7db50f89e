// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  gl_SampleMask[0] = base.x > 0.35 ? 0 : gl_SampleMaskIn[0];
  color = vec4(base * waves(place.x), 1.0);
}

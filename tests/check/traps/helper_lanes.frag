// expect: refused shader.helper_invocation
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = marble(place);
  float bump = gl_HelperInvocation ? 0.0 : waves(place.x);
  color = vec4(base * (1.0 + dFdx(bump)), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(push_constant) uniform Push { layout(offset = 16) vec3 tint; float gain; mat2 turn; } push;
void main() {
  vec3 base = marble(place * push.gain);
  color = vec4(base * push.tint * waves((push.turn * place.xy).x), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void tone(inout vec4 value) { value.xyz = value.xyz / (1.0 + value.xyz); }
void main() {
  color = vec4(marble(place), 1.0);
  color += 0.25 * color.zxyw;
  tone(color);
  color.xyz *= waves(color.x);
}

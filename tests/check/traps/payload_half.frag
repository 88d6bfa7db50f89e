// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
#extension GL_EXT_shader_explicit_arithmetic_types : require
void main() {
  f16vec3 base = f16vec3(marble(place));
  f16vec3 bright = base * float16_t(1.5) + sqrt(abs(base));
  color = vec4(vec3(bright) * place.x, 1.0);
}

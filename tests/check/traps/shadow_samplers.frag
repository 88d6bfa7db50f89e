// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2DShadow shadow;
layout(set = 0, binding = 1) uniform sampler2DArrayShadow cascades;
void main() {
  float lit = 0.0;
  for (int i = 0; i < 4; ++i) lit += 0.25 * texture(shadow, vec3(uv + 0.03 * float(i), 0.5 + 0.2 * place.x));
  lit += textureGradOffset(cascades, vec4(uv, 1.0, 0.45), vec2(0.1), vec2(0.1), ivec2(1));
  color = vec4(marble(place) * (0.2 + lit), 1.0);
}

// expect: refused shader.side_effects
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, rgba8) uniform image2D trail;
void main() {
  vec3 base = marble(place);
  imageStore(trail, ivec2(gl_FragCoord.xy), vec4(base, 1.0));
  color = vec4(base, 1.0);
}

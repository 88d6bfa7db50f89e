// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

void main() {
  float side = place.x;
  if (side > light.tint.x * 0.4) {
    color = vec4(marble(place), 1.0);
  } else {
    discard;
  }
}

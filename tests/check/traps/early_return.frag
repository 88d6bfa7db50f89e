// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

void main() {
  if (uv.x < 0.3) {
    color = light.tint;
    return;
  }
  vec3 base = marble(place);
  if (base.x < 0.2) {
    color = vec4(base.zyx * waves(place.x), 1.0);
    return;
  }
  color = vec4(base * waves(place.y), 1.0);
}

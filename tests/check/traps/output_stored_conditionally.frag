// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  color = vec4(0.1, 0.2, 0.3, 1.0);
  vec3 base = marble(place);
  if (place.x > 0.0) color = vec4(base * waves(place.y), 1.0);
  if (base.y > 0.25) color.x = base.z;
}

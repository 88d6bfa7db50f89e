// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 base = place;
  for (int i = 0; i < 4; ++i)
    if (sin(base.x * 9.0 + float(i)) > 0.8) base += marble(base);
  color = vec4(marble(base) * waves(place.x), 1.0);
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) flat in int kind;
void main() {
  vec3 base = marble(place);
  switch (kind) {
    case 0: base = base.zxy * waves(place.x); break;
    case 1: base += sin(place * 9.0); break;
    case 3: base = marble(base); break;
    default: base *= 0.5;
  }
  color = vec4(base, 1.0);
}

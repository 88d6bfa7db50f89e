// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) in vec2 rows[3];
void main() {
  int row = int(place.x * 3.0 + 6.0) % 3;
  color = vec4(marble(vec3(rows[row], place.z)) * waves(rows[2].x), rows[1].y);
}

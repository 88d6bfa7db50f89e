// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, std430) readonly buffer Points { int count; vec4 points[]; } data;
void main() {
  vec3 base = marble(place);
  float nearest = 9.0;
  for (int i = 0; i < data.count + 3; ++i) nearest = min(nearest, distance(place, data.points[i].xyz * 2.0 - 1.0));
  color = vec4(base * waves(nearest), float(data.points.length() > 3));
}

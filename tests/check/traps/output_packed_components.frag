// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0, component = 0) out vec2 low;
layout(location = 0, component = 2) out vec2 high;
layout(location = 1, component = 1) out vec3 other;
void main() {
  vec3 base = marble(place);
  low = base.xy;
  high = vec2(base.z * waves(place.x), 1.0);
  other = base.zyx * waves(place.y);
}

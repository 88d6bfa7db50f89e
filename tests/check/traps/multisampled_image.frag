// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2DMS resolved;
void main() {
  vec3 base = marble(place);
  for (int i = 0; i < 4; ++i) base += 0.25 * texelFetch(resolved, ivec2(abs(uv) * 15.0), i).xyz;
  color = vec4(base * waves(place.x), 1.0);
}

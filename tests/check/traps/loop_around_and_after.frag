// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
  vec3 q = place, kept = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    vec3 inner = marble(q);
    if (inner.x > 0.2) kept = inner;
    q = q.zxy + 0.2 * inner;
  }
  vec3 after = marble(q + kept);
  color = vec4(after + waves(kept.x), 1.0);
}

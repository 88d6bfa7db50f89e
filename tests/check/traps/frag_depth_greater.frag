// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(depth_greater) out float gl_FragDepth;
void main() {
  vec3 base = marble(place);
  gl_FragDepth = clamp(gl_FragCoord.z + 0.0078125 * abs(uv.x), 0.0, 0.999);
  color = vec4(base * waves(place.y), 1.0);
}

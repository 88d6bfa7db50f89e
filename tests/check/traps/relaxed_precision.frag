// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) in mediump vec3 normal;
void main() {
  mediump vec3 n = normalize(normal + 0.2 * place);
  mediump float shine = pow(max(dot(n, vec3(0.3, 0.8, 0.5)), 0.0), 8.0);
  color = vec4(marble(place) * shine + waves(n.x), 1.0);
}

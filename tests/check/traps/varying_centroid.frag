// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) centroid in vec2 inner_uv;
void main() { color = vec4(marble(vec3(inner_uv, place.z)) + fwidth(inner_uv.x), 1.0); }

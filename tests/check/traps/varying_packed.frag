// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2, component = 0) in vec2 low;
layout(location = 2, component = 2) in float high;
void main() { color = vec4(marble(vec3(low, high)) * waves(high), 1.0); }

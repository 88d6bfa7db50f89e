// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) noperspective in vec2 screen_uv;
void main() { color = vec4(marble(vec3(screen_uv, place.z)) * waves(screen_uv.x), 1.0); }

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) flat in vec3 face;
layout(location = 3) flat in uint id;
void main() { color = vec4(marble(face + place) * waves(face.x), float(id)); }

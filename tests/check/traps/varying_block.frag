// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) in Corner { vec3 tangent; vec2 wear; } corner;
void main() { color = vec4(marble(corner.tangent) * waves(corner.wear.y), corner.wear.x); }

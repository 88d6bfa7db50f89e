// expect: refused shader.sample_rate
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(location = 2) sample in vec3 fine;
void main() { color = vec4(marble(fine) * waves(place.x), 1.0); }

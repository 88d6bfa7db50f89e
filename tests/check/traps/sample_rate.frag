// expect: refused shader.sample_rate
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = vec4(marble(place) * float(gl_SampleID + 1) + waves(gl_SamplePosition.x), 1.0); }

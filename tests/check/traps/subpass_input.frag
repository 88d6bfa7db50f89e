// expect: refused shader.subpass_input
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput previous;
void main() { color = vec4(marble(place), 1.0) * subpassLoad(previous); }

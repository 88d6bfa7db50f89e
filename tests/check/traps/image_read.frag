// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D floats;
layout(set = 0, binding = 1, rgba8) uniform readonly image2D bytes;
layout(set = 0, binding = 2, rgba16f) uniform readonly image2D halves;
layout(set = 0, binding = 3, r32ui) uniform readonly uimage2D ids;
layout(set = 0, binding = 4, rg16f) uniform readonly image2D slopes;
layout(set = 0, binding = 5, r8i) uniform readonly iimage2D small;
void main() {
  ivec2 at = ivec2(abs(uv) * 15.0);
  vec4 sum = imageLoad(floats, at) + imageLoad(bytes, at) + imageLoad(halves, at) + imageLoad(slopes, at);
  color = vec4(marble(place) * sum.xyz, float(imageLoad(ids, at).x) + float(imageLoad(small, at).x));
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 1) uniform sampler2D albedo;
void main() {
  vec3 base = marble(place);
  vec2 size = vec2(textureSize(albedo, 0));
  float level = textureQueryLod(albedo, uv * 3.0).x;
  color = vec4(base * textureLod(albedo, uv, level).xyz + textureGather(albedo, uv).xyz / size.x, textureQueryLevels(albedo));
}

// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Light { vec4 tint; vec4 steps; ivec4 counts; } light;

struct Surface { vec3 albedo; float gloss; vec2 slope; };
Surface describe(vec3 p) {
  Surface s = Surface(marble(p), waves(p.x), vec2(0.0));
  s.slope.y = waves(p.y);
  return s;
}
void main() {
  Surface s = describe(place), other = s;
  other.albedo = light.tint.xyz;
  if (s.gloss > 0.1) s = other;
  color = vec4(s.albedo * s.gloss, s.slope.y);
}

// expect: verified
// A texture and a sampler of their own at one binding: the two halves of a combined image sampler.
#version 450
layout(set = 0, binding = 0) uniform texture2D relief;
layout(set = 0, binding = 0) uniform sampler smooth_sampler;
layout(set = 0, binding = 1) uniform texture2D tint;
layout(set = 0, binding = 1) uniform samplerShadow compare_sampler;
layout(location = 0) in vec3 world_position;
layout(location = 0) out vec4 color;

void main() {
  vec2 place = world_position.xy;
  float height = 0.0;
  for (int i = 0; i < 6; ++i) {
    height += textureLod(sampler2D(relief, smooth_sampler), place, 0.0).x * exp2(-float(i));
    place = place * 1.7 + vec2(0.31, -0.17);
  }
  float lit = textureLod(sampler2DShadow(tint, compare_sampler), vec3(fract(world_position.yz), 0.4), 0.0);
  color = vec4(sin(height * 9.0), height * lit, cos(height), 1.0);
}

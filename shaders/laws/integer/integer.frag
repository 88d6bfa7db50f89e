// Integers as the payload, negative ones too: a scramble of lattice cells. The colour shows lowest and highest bits.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

const int kRounds = 64;

ivec2 scramble(ivec3 cell) {
  ivec2 mixed = cell.xy * 73 + cell.z * 31;
  for (int i = 0; i < kRounds; ++i) {
    mixed = mixed * ivec2(1664525, 22695477) + mixed.yx + cell.zx;
    mixed ^= mixed >> 7;
  }
  return mixed * 747796405 ^ (mixed >> 13);
}

void main() {
  ivec2 key = scramble(ivec3(floor(object_position * 9.0)));
  vec2 tint = vec2(key.x & 255, uint(key.y) >> 24) * (scene.shininess * 0.00015);
  color = vec4(lightSurface(vec3(tint, 0.4), world_position, world_normal), 1.0);
}

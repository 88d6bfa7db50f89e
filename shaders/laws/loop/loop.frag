// A loop that every pixel leaves after another number of rounds.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

const int kMostRounds = 24;

void main() {
  vec2 z = object_position.xy * 1.1 + 0.15 * object_position.z;
  vec2 step_by = vec2(-0.62, 0.41);
  float heat = 0.0;
  for (int i = 0; i < kMostRounds; ++i) {
    z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + step_by;
    float size = dot(z, z);
    if (size > 16.0) break;
    heat += exp(-size);
  }
  float glow = heat / float(kMostRounds);
  vec3 base = mix(vec3(0.15, 0.2, 0.45), vec3(0.9, 0.7, 0.3), clamp(glow * 1.6, 0.0, 1.0));
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

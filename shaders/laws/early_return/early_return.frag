// Leaves main early after the expensive part; the function that computes it has two exits of its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

float rings(vec3 p) {
  float distance_to_axis = length(p.xz);
  float wave = sin(14.0 * distance_to_axis + 2.0 * sin(3.0 * p.y)) + 0.4 * sin(31.0 * p.x * p.y + 5.0 * p.z);
  if (wave < 0.0) return 0.35 + 0.1 * exp(wave);
  return 0.35 + 0.3 * sqrt(wave);
}

void main() {
  float grain = rings(object_position) * (0.8 + 0.2 * cos(9.0 * object_position.y + 4.0 * rings(object_position.zxy)));
  vec3 base = vec3(1.0, 0.75, 0.5) * grain;
  float facing = dot(normalize(world_normal), normalize(scene.camera_position - world_position));
  if (facing < 0.25) {
    color = vec4(base * 0.5, 1.0);
    return;
  }
  color = vec4(lightSurface(base, world_position, world_normal) + 0.1 * facing, 1.0);
}

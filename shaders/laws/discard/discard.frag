// Holes: fragments are discarded before the expensive part.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 cell = fract(object_position * 2.5 + 0.25) - 0.5;
  if (dot(cell, cell) < 0.06) discard;
  vec3 p = object_position * 4.0;
  float swirl = sin(p.x + 2.0 * cos(p.y)) + sin(p.y + 2.0 * cos(p.z)) + sin(p.z + 2.0 * cos(p.x));
  float veins = 0.5 + 0.5 * sin(3.0 * swirl + 0.5 * exp(sin(p.x * p.y)));
  vec3 base = mix(vec3(0.2, 0.45, 0.3), vec3(0.85, 0.9, 0.7), pow(veins, 1.5));
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

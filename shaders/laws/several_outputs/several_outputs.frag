// Two colour outputs: the lit surface, and the material with the direction to the camera.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;
layout(location = 1) out vec4 material;

void main() {
  vec3 p = object_position * 2.5;
  float bumps = sin(4.0 * p.x + sin(3.0 * p.y)) * sin(4.0 * p.y + sin(3.0 * p.z)) * sin(4.0 * p.z + sin(3.0 * p.x));
  float rust = 0.5 + 0.5 * sin(6.0 * bumps + log(2.0 + dot(p, p)) * cos(2.0 * p.y));
  vec3 base = mix(vec3(0.5, 0.52, 0.55), vec3(0.6, 0.3, 0.15), rust * rust);
  float facing = max(dot(normalize(world_normal), normalize(scene.camera_position - world_position)), 0.0);
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
  material = vec4(rust, 0.3 + 0.5 * rust, facing, 1.0);
}

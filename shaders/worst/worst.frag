// A mirror under a sky with bands of interference: all that costs anything depends on where the camera is and on a lamp that
// flickers. Nothing here is worth keeping for the next frame.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

#ifndef BOUNCES
#define BOUNCES 12
#endif

layout(set = 0, binding = 1) uniform sampler2D sky;
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 0) out vec4 color;

const float kPi = 3.14159265;

vec3 skyIn(vec3 direction) {
  vec2 at = vec2(atan(direction.x, direction.z) / (2.0 * kPi) + 0.5, acos(clamp(direction.y, -1.0, 1.0)) / kPi);
  return textureLod(sky, at, 0.0).rgb;
}

// The thickness of a film that the ray crosses at an angle gives each bounce its tint.
vec3 bandsOf(vec3 direction, float thickness) {
  return 0.5 + 0.5 * cos(thickness * vec3(9.0, 11.0, 14.0) * (1.2 - abs(direction.y)) + 40.0 * direction.x);
}

void main() {
  vec3 normal = normalize(world_normal);
  vec3 ray = reflect(normalize(world_position - scene.camera_position.xyz), normal);
  vec3 lamp = normalize(scene.lamp_position.xyz - world_position);
  vec3 light = vec3(0.0);
  float weight = 1.0;
  for (int i = 0; i < BOUNCES; ++i) {
    vec3 ripple = sin(ray.zxy * (6.0 + float(i)) + 1.7 * float(i));
    ray = normalize(ray + 0.12 * ripple);
    vec3 glint = scene.lamp_color.rgb * pow(max(dot(ray, lamp), 0.0), 60.0);
    light += weight * bandsOf(ray, 1.0 + float(i)) * (skyIn(ray) + glint);
    weight *= 0.8;
  }
  float fresnel = 0.2 + 0.8 * pow(1.0 - max(dot(normal, reflect(ray, normal)), 0.0), 5.0);
  color = vec4(fresnel * light * scene.lamp_color.a, 1.0);
}

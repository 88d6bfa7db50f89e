// The marble of Scherzer et al. 2012, section 4.1: an albedo of OCTAVES octaves of Perlin noise under one light,
// Blinn-Phong. The albedo sticks to the object; only the lighting depends on the camera.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "noise.glsl"
#include "scene.glsl"

#ifndef OCTAVES
#define OCTAVES 5
#endif

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

const vec3 kVeinColor = vec3(0.27, 0.22, 0.25);
const vec3 kStoneColor = vec3(0.86, 0.82, 0.76);
const vec3 kTintColor = vec3(0.66, 0.52, 0.42);

vec3 marble(vec3 position) {
  vec3 p = position * 1.3;
  float turbulence = 0.0;
  float amplitude = 1.0;
  for (int i = 0; i < OCTAVES; ++i) {
    turbulence += amplitude * abs(noise3(p));
    p = p * 2.0 + vec3(17.3, -9.1, 4.7);
    amplitude *= 0.5;
  }
  float vein = 0.5 + 0.5 * sin(3.0 * (position.x + 0.6 * position.y + 0.3 * position.z) + 4.0 * turbulence);
  vec3 stone = mix(kTintColor, kStoneColor, smoothstep(0.1, 0.75, vein));
  return mix(kVeinColor, stone, smoothstep(0.0, 0.5, vein));
}

void main() {
  vec3 albedo = marble(object_position);

  vec3 normal = normalize(world_normal);
  vec3 to_light = normalize(scene.light_position.xyz - world_position);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  vec3 halfway = normalize(to_light + to_camera);
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), 48.0) : 0.0;

  vec3 lit = albedo * (scene.ambient_color.rgb + diffuse * scene.light_color.rgb);
  color = vec4(lit + 0.45 * specular * scene.light_color.rgb, 1.0);
}

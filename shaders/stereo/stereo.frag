// A noise shader as in Nehab et al. 2007, section 7.2: an albedo of OCTAVES octaves of 3D Perlin noise under one light, Blinn-Phong.
// Only the highlight depends on where the camera is.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../marble/noise.glsl"
#include "../marble/scene.glsl"

#ifndef OCTAVES
#define OCTAVES 4
#endif

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

const vec3 kClay = vec3(0.62, 0.38, 0.27);
const vec3 kGlaze = vec3(0.24, 0.45, 0.47);
const vec3 kGrain = vec3(0.88, 0.82, 0.68);

vec3 stainedClay(vec3 position) {
  vec3 p = position * 1.7;
  float stain = 0.0;
  float grain = 0.0;
  float amplitude = 0.55;
  for (int i = 0; i < OCTAVES; ++i) {
    float noise = noise3(p);
    stain += amplitude * noise;
    grain += amplitude * abs(noise);
    p = p * 2.03 + vec3(11.7, 5.1, -8.3);
    amplitude *= 0.5;
  }
  vec3 base = mix(kClay, kGlaze, smoothstep(-0.15, 0.3, stain));
  return mix(kGrain, base, smoothstep(0.02, 0.3, grain));
}

void main() {
  vec3 albedo = stainedClay(object_position);

  vec3 normal = normalize(world_normal);
  vec3 to_light = normalize(scene.light_position.xyz - world_position);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  vec3 halfway = normalize(to_light + to_camera);
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), 32.0) : 0.0;

  vec3 lit = albedo * (scene.ambient_color.rgb + diffuse * scene.light_color.rgb);
  color = vec4(lit + 0.3 * specular * scene.light_color.rgb, 1.0);
}

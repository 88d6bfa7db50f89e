// The dragon of Nehab et al. 2007, section 5 and figure 6: a diffuse layer of Perlin noise and a specular layer, while the camera and a point
// light move.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../marble/noise.glsl"
#include "scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

const vec3 kJadeColor = vec3(0.26, 0.5, 0.36);
const vec3 kPaleColor = vec3(0.74, 0.8, 0.62);
const vec3 kRustColor = vec3(0.5, 0.3, 0.2);

float turbulence(vec3 p, int octaves) {
  float sum = 0.0, amplitude = 0.5;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * noise3(p);
    p = p * 2.02 + vec3(3.1, 8.7, -5.9);
    amplitude *= 0.5;
  }
  return sum;
}

void main() {
  vec3 bent = object_position * 2.2 + 0.8 * vec3(turbulence(object_position * 1.7, 4), turbulence(object_position.zxy * 1.7 + 9.0, 4), 0.0);
  float cloud = turbulence(bent, 8);
  vec3 diffuse_color = mix(kJadeColor, kPaleColor, smoothstep(-0.25, 0.35, cloud));
  diffuse_color = mix(diffuse_color, kRustColor, smoothstep(0.15, 0.5, turbulence(bent * 2.6 + 21.0, 5)));

  vec3 normal = normalize(world_normal);
  vec3 to_light = normalize(scene.light_position.xyz - world_position);
  vec3 halfway = normalize(to_light + normalize(scene.camera_position.xyz - world_position));
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), 24.0) : 0.0;
  vec3 lit = diffuse_color * (0.2 + 0.8 * diffuse) + vec3(0.25) * specular;
  color = vec4(lit, 1.0);
}

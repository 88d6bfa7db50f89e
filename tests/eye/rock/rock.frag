// A dark, wet rock: bumps and stains from noise, a glossy lobe from one light. Light is linear, scaled by the exposure, then encoded.
#version 450

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_position;
  float exposure;
} scene;

float cornerValue(uint lattice_hash, vec3 offset) {
  uint h = lattice_hash;
  h = (h ^ (h >> 13u)) * 0x5bd1e995u;
  h ^= h >> 15u;
  vec3 gradient = vec3(uvec3(h, h >> 10u, h >> 20u) & 1023u) * (2.0 / 1023.0) - 1.0;
  return dot(gradient, offset);
}

// Gradient noise, about -1 to 1.
float noise3(vec3 p) {
  vec3 cell = floor(p);
  vec3 f = p - cell;
  uvec3 low = uvec3(ivec3(cell)) * uvec3(73856093u, 19349663u, 83492791u);
  uvec3 high = low + uvec3(73856093u, 19349663u, 83492791u);
  vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec4 near_x = vec4(cornerValue(low.x ^ low.y ^ low.z, f), cornerValue(low.x ^ high.y ^ low.z, f - vec3(0, 1, 0)),
                     cornerValue(low.x ^ low.y ^ high.z, f - vec3(0, 0, 1)), cornerValue(low.x ^ high.y ^ high.z, f - vec3(0, 1, 1)));
  vec4 far_x = vec4(cornerValue(high.x ^ low.y ^ low.z, f - vec3(1, 0, 0)), cornerValue(high.x ^ high.y ^ low.z, f - vec3(1, 1, 0)),
                    cornerValue(high.x ^ low.y ^ high.z, f - vec3(1, 0, 1)), cornerValue(high.x ^ high.y ^ high.z, f - vec3(1, 1, 1)));
  vec4 along_x = mix(near_x, far_x, w.x);
  vec2 along_y = mix(along_x.xz, along_x.yw, w.y);
  return mix(along_y.x, along_y.y, w.z);
}

vec3 toSrgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

float heightAt(vec3 p) {
  float height = 0.0;
  float amplitude = 0.5;
  for (int i = 0; i < 5; ++i) {
    height += amplitude * noise3(p);
    p = p * 1.8 + vec3(5.7, -3.1, 9.2);
    amplitude *= 0.5;
  }
  return height;
}

void main() {
  vec3 p = 1.6 * object_position;
  const float kStep = 0.04;
  float height = heightAt(p);
  vec3 slope = (vec3(heightAt(p + vec3(kStep, 0, 0)), heightAt(p + vec3(0, kStep, 0)), heightAt(p + vec3(0, 0, kStep))) - height) / kStep;
  vec3 albedo = mix(vec3(0.0115, 0.011, 0.01), vec3(0.026, 0.022, 0.0175), smoothstep(-0.3, 0.3, height));

  vec3 smooth_normal = normalize(world_normal);
  vec3 normal = normalize(smooth_normal - 0.5 * (slope - smooth_normal * dot(slope, smooth_normal)));
  vec3 to_light = normalize(scene.light_position.xyz - world_position);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  float diffuse = max(dot(normal, to_light), 0.0);
  float gloss = diffuse > 0.0 ? pow(max(dot(normal, normalize(to_light + to_camera)), 0.0), 40.0) : 0.0;
  vec3 light = albedo * (0.12 + 0.9 * diffuse) + 0.09 * gloss;
  color = vec4(toSrgb(scene.exposure * light), 1.0);
}

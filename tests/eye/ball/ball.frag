// A bright marble ball under a light that moves: veins of warped noise in five octaves, a specular lobe.
#version 450

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_position;
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

void main() {
  vec3 p = 1.0 * object_position;
  for (int i = 0; i < 3; ++i) {
    p += 0.15 * vec3(noise3(p + 31.0), noise3(p - 17.0), noise3(p.zxy + 53.0));
  }
  float turbulence = 0.0;
  float amplitude = 1.0;
  for (int i = 0; i < 5; ++i) {
    turbulence += amplitude * abs(noise3(p));
    p = 1.8 * p + vec3(17.3, -9.1, 4.7);
    amplitude *= 0.5;
  }
  float vein = 0.5 + 0.5 * sin(4.0 * (object_position.x + 0.6 * object_position.y) + 2.0 * turbulence);
  vec3 albedo = mix(vec3(0.3, 0.24, 0.27), mix(vec3(0.62, 0.48, 0.38), vec3(0.85, 0.82, 0.76), vein), smoothstep(0.0, 0.7, vein));

  vec3 normal = normalize(world_normal);
  vec3 to_light = normalize(scene.light_position.xyz - world_position);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  float diffuse = max(dot(normal, to_light), 0.0);
  float specular = diffuse > 0.0 ? pow(max(dot(normal, normalize(to_light + to_camera)), 0.0), 60.0) : 0.0;
  color = vec4(toSrgb(albedo * (0.2 + 0.65 * diffuse) + 0.35 * specular), 1.0);
}

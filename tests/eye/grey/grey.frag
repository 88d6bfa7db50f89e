// A flat grey plane: a slow gradient, costly noise of low contrast and a faint sheen.
#version 450

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
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
  vec3 p = 0.7 * object_position + vec3(0.0, 3.7, 0.0);
  float mottle = 0.0;
  float amplitude = 0.5;
  p += 0.5 * vec3(noise3(p + 11.0), 0.0, noise3(p - 23.0));
  for (int i = 0; i < 7; ++i) {
    mottle += amplitude * noise3(p);
    p = 1.5 * p + vec3(3.1, 0.7, -5.3);
    amplitude *= 0.7;
  }
  float albedo = 0.22 + 0.012 * object_position.x + 0.035 * mottle;

  vec3 normal = normalize(world_normal);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);
  vec3 halfway = normalize(to_camera + normalize(vec3(0.5, 1.0, -0.8)));
  float sheen = pow(max(dot(normal, halfway), 0.0), 12.0);
  color = vec4(toSrgb(vec3(albedo + 0.05 * sheen)), 1.0);
}

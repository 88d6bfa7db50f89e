// A street at night: wet asphalt and walls of noise under five lamps, whose bulbs glow.
#version 450

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 lamps[5];
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
  vec3 normal = normalize(world_normal);
  vec3 to_camera = normalize(scene.camera_position.xyz - world_position);

  vec3 p = 1.2 * world_position;
  for (int i = 0; i < 3; ++i) {
    p += 0.2 * vec3(noise3(p + 31.0), noise3(p - 17.0), noise3(p.zxy + 53.0));
  }
  float grain = 0.0;
  float amplitude = 0.5;
  for (int i = 0; i < 4; ++i) {
    grain += amplitude * abs(noise3(p));
    p = 2.1 * p + vec3(7.1, -2.9, 4.3);
    amplitude *= 0.6;
  }
  float wetness = smoothstep(-0.1, 0.3, noise3(0.7 * world_position + 5.0));
  vec3 albedo = mix(vec3(0.05, 0.05, 0.055), vec3(0.16, 0.13, 0.11), clamp(2.0 * grain - 0.2, 0.0, 1.0));

  vec3 diffuse = vec3(0.0);
  vec3 gloss = vec3(0.0);
  vec3 glow = vec3(0.0);
  for (int i = 0; i < 5; ++i) {
    vec3 warm = mix(vec3(1.0, 0.62, 0.28), vec3(0.75, 0.85, 1.0), scene.lamps[i].w);
    vec3 offset = scene.lamps[i].xyz - world_position;
    float square = dot(offset, offset);
    vec3 to_lamp = offset * inversesqrt(square);
    // Lamps are hooded: nothing goes up, and little far aside.
    vec3 light = warm * smoothstep(0.35, 0.9, to_lamp.y) * 10.0 / (1.0 + square);
    float facing = max(dot(normal, to_lamp), 0.0);
    diffuse += light * facing;
    gloss += light * facing * pow(max(dot(normal, normalize(to_lamp + to_camera)), 0.0), 90.0);
    glow += square < 0.03 ? warm : vec3(0.0);
  }
  vec3 lit = albedo * (0.012 + diffuse) + wetness * 0.5 * gloss + 1.2 * glow;
  color = vec4(toSrgb(lit), 1.0);
}

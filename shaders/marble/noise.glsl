// Perlin's gradient noise in three dimensions, with hashed gradients instead of a table.
#ifndef MARBLE_NOISE_GLSL
#define MARBLE_NOISE_GLSL

const uvec3 kLatticeStep = uvec3(73856093u, 19349663u, 83492791u);

// The dot product of a lattice point's gradient, from its hash, with the offset from it.
float gradientDot(uint lattice_hash, vec3 offset) {
  uint h = lattice_hash;
  h = (h ^ (h >> 13u)) * 0x5bd1e995u;
  h ^= h >> 15u;
  vec3 gradient = vec3(uvec3(h, h >> 10u, h >> 20u) & 1023u) * (2.0 / 1023.0) - 1.0;
  return dot(gradient, offset);
}

// About -1 to 1, 0 at lattice points; quintic blending, so that first and second derivatives are continuous.
float noise3(vec3 p) {
  vec3 cell = floor(p);
  vec3 f = p - cell;
  uvec3 low = uvec3(ivec3(cell)) * kLatticeStep;
  uvec3 high = low + kLatticeStep;
  vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n000 = gradientDot(low.x ^ low.y ^ low.z, f);
  float n100 = gradientDot(high.x ^ low.y ^ low.z, f - vec3(1.0, 0.0, 0.0));
  float n010 = gradientDot(low.x ^ high.y ^ low.z, f - vec3(0.0, 1.0, 0.0));
  float n110 = gradientDot(high.x ^ high.y ^ low.z, f - vec3(1.0, 1.0, 0.0));
  float n001 = gradientDot(low.x ^ low.y ^ high.z, f - vec3(0.0, 0.0, 1.0));
  float n101 = gradientDot(high.x ^ low.y ^ high.z, f - vec3(1.0, 0.0, 1.0));
  float n011 = gradientDot(low.x ^ high.y ^ high.z, f - vec3(0.0, 1.0, 1.0));
  float n111 = gradientDot(high.x ^ high.y ^ high.z, f - vec3(1.0, 1.0, 1.0));
  vec4 along_x = mix(vec4(n000, n010, n001, n011), vec4(n100, n110, n101, n111), w.x);
  vec2 along_y = mix(along_x.xz, along_x.yw, w.y);
  return mix(along_y.x, along_y.y, w.z);
}

#endif

// What the traps compute: worth caching, cheap to compile.
vec3 marble(vec3 p) {
  vec3 q = p * 3.1 + 0.4 * sin(p.zxy * 5.3);
  float veins = sin(q.x * 2.0 + 1.7 * cos(q.y * 1.9 + q.z)) + 0.5 * sin(q.y * 4.1 - q.z * 3.3);
  float grain = fract(sin(dot(floor(q * 8.0), vec3(12.98, 78.23, 37.72))) * 437.58);
  vec3 stone = mix(vec3(0.85, 0.83, 0.78), vec3(0.3, 0.34, 0.4), smoothstep(-0.8, 0.9, veins));
  return stone * (0.9 + 0.2 * grain) * exp(-0.2 * dot(q, q) / (1.0 + abs(veins)));
}

float waves(float x) {
  return sin(x * 3.0 + cos(x * 5.0)) * exp(-0.1 * x * x) + pow(abs(x) + 0.5, 1.3) * 0.2;
}

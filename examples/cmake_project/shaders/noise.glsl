// Layers of folded sines: enough work to be worth keeping.
float layers(vec3 point, int count) {
  float sum = 0.0;
  float weight = 0.5;
  for (int i = 0; i < count; ++i) {
    sum += weight * abs(sin(point.x + 1.3 * sin(point.y + sin(point.z))));
    point = point.yzx * 1.37 + vec3(0.31, 0.17, 0.53);
    weight *= 0.93;
  }
  return sum * 0.15;
}

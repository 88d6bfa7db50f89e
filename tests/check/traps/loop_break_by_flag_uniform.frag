// expect: verified
#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Counts { int outer, inner; } counts;
bool never(float x) { return x > 1e20; }
// loop_break_by_flag.frag with both counts as uniforms.
void main() {
  int acc = 0, last = 0;
  float w = 1.0;
  for (int i = 0; i < counts.outer; ++i) {
    if (never(uv.x)) {
      if (never(uv.y)) continue;
      break;
    } else {
      acc = last;
      for (int j = 0; j < counts.inner; ++j) {
        last = 1;
        w *= 0.5;
      }
      acc |= last;
    }
  }
  float heavy = 0.0;
  for (int s = 0; s < 40; ++s) heavy += sin(uv.x * float(s)) * w;
  color = vec4(vec3(float(acc)), 0.5 + 0.01 * heavy) * (0.5 + 0.5 * uv.y);
}

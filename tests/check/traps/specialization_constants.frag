// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(constant_id = 0) const int kRounds = 3;
layout(constant_id = 1) const float kGain = 0.7;
layout(constant_id = 2) const bool kTwice = true;
layout(constant_id = 3) const int kSize = 4;
const int kHalf = kSize / 2 + kRounds;
void main() {
  float table[kSize];
  for (int i = 0; i < kSize; ++i) table[i] = waves(place.x + float(i));
  vec3 base = marble(place);
  for (int i = 0; i < kRounds; ++i) base = base.yzx * kGain + 0.2 * sin(base * 3.0);
  if (kTwice) base += waves(base.x);
  color = vec4(base * table[kHalf % kSize], 1.0);
}

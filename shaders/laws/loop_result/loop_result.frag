// A fractal sum with a varying number of octaves, used after the loop.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 p = object_position * 3.0;
  int octaves = 3 + int(2.0 * fract(p.x + p.y));
  float sum = 0.4;
  float scale = 0.35;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += scale * sin(p.x + cos(p.y * 1.7 + sum)) * cos(p.z);
    p = p.yzx * 1.9 + 0.37;
    scale *= 0.55;
    if (sum > 0.9) break;
  }
  vec3 base = vec3(0.5) + 0.4 * sum * vec3(1.0, 0.8, 0.6);
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

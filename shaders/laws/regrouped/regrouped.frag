// Four waves stand still and one moves: the four are kept together, though the source adds them around the fifth.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

float wave(vec3 p, float shift) { return 0.1 * sin(p.x + 1.7 * sin(p.y + shift) + exp(-abs(cos(p.z * shift)))); }

void main() {
  vec3 p = object_position * 4.0;
  float height = wave(p, 0.3) + wave(p.yzx, 1.1) + 0.1 * sin(p.x + scene.time_s) + wave(p.zxy, 2.3) + wave(p.xzy, 3.1);
  vec3 base = vec3(0.5) + height * vec3(0.6, 0.5, 0.4);
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

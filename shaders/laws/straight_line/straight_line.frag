// One block without a branch: a chain of transcendental functions, then the light.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 p = object_position * 3.0;
  float first = sin(p.x + 1.7 * sin(p.y + 0.3)) * cos(p.z + 0.8 * sin(p.x));
  float second = exp(-abs(sin(2.3 * p.y + first))) * sqrt(1.0 + dot(p, p));
  float third = log(1.5 + second * second) * sin(first * 3.0 + p.z);
  float fourth = pow(abs(cos(third + 0.5 * second)), 1.3) + 0.2 * atan(third, 1.0 + second);
  vec3 base = 0.5 + 0.35 * sin(vec3(0.0, 2.1, 4.2) + 2.0 * fourth + p);
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

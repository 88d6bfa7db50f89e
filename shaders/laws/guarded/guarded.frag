// Veins only where the stone is cracked; the crack wanders, so that pixels begin and cease to need them.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  vec3 p = object_position * 4.0;
  vec3 base = vec3(0.4, 0.35, 0.3);
  if (sin(p.x + 0.6 * p.y + 2.0 * scene.time_s) > 0.1) {
    float first = sin(p.x + 1.7 * sin(p.y + 0.3)) * cos(p.z + 0.8 * sin(p.x));
    float second = exp(-abs(sin(2.3 * p.y + first))) * sqrt(1.0 + dot(p, p));
    float vein = 0.5 + 0.4 * sin(log(1.5 + second * second) * sin(first * 3.0 + p.z));
    base += vein * vec3(0.5, 0.3, 0.2);
  }
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

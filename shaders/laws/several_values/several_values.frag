// Colour, bump and gloss are steady and dear; the light that joins them changes with the camera.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

vec3 wave(vec3 p) { return sin(p + 1.3 * cos(p.yzx * 1.7 + 0.4 * exp(-p.zxy * p.zxy))); }

void main() {
  vec3 p = object_position * 4.0;
  vec3 base = 0.5 + 0.3 * wave(wave(p) + p.zxy);
  vec3 bump = 0.15 * wave(wave(p * 1.9 + 0.7) - p.yzx);
  float gloss = 0.5 + 0.4 * sin(exp(-abs(cos(p.x * 2.3))) + log(1.5 + p.y * p.y) * cos(p.z + sqrt(1.0 + p.x * p.x)));
  vec3 lit = lightSurface(base, world_position, world_normal + bump);
  color = vec4(lit * gloss + 0.1 * bump, 1.0);
}

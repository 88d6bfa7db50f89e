// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0, std140) uniform Lights { vec4 colors[8]; mat4 bones[3]; int count; } lights;
void main() {
  vec3 base = marble(place), sum = vec3(0.0);
  for (int i = 0; i < lights.count + 2; ++i) sum += lights.colors[i].xyz * waves(place.x + float(i));
  int bone = int(abs(base.x) * 2.9) % 3;
  color = vec4(base * sum + (lights.bones[bone] * vec4(place, 1.0)).xyz, 1.0);
}

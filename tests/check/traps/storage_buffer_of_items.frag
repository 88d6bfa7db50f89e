// expect: verified
// Integers in an array without a size: they are small, as those of other blocks.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
struct Item { vec4 tint; int steps; };
layout(std430, set = 0, binding = 0) readonly buffer Items { Item list[]; } items;
layout(set = 0, binding = 1) uniform Scene { vec4 tint; int item; } scene;
void main() {
  Item item = items.list[scene.item];
  vec3 base = marble(place);
  for (int i = 0; i < item.steps; ++i) base += 0.1 * sin(base * float(i + 2));
  color = vec4(base * scene.tint.xyz * item.tint.xyz * waves(uv.x), 1.0);
}

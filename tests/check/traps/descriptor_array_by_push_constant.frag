// expect: verified
// An integer of the application's indexes an array of descriptors, and stays within it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D maps[2];
layout(set = 0, binding = 2) uniform Scene { vec4 tint; int map; } scene;
layout(push_constant) uniform Draw { int map; } draw;
void main() {
  vec3 base = marble(place) * texture(maps[draw.map], uv).xyz;
  color = vec4(base * scene.tint.xyz * waves(place.x) + texture(maps[scene.map], uv.yx).xyz, 1.0);
}

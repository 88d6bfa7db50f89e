// expect: verified
// The index is the same for a whole draw, as it has to be, and stays within the array.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 2) flat in uint map;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D maps[2];
layout(set = 0, binding = 2) uniform Scene { vec4 tint; } scene;
void main() {
  vec3 base = marble(place) * texture(maps[map], uv).xyz;
  color = vec4(base * scene.tint.xyz * waves(place.x), 1.0);
}

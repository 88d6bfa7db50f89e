// expect: verified
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_nonuniform_qualifier : require
#include "surface.glsl"
layout(location = 0) in vec3 place;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D pictures[];
layout(location = 2) flat in int material;
void main() {
  vec3 base = marble(place) * textureLod(pictures[nonuniformEXT(material)], uv, 0.0).xyz;
  color = vec4(base * waves(place.x), 1.0);
}

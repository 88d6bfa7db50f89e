// Two textures, sampled with implicit level of detail, one of them at coordinates that are computed.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 3) in vec2 surface_uv;
layout(set = 0, binding = 1) uniform sampler2D pattern_map;
layout(set = 0, binding = 2) uniform sampler2D grain_map;
layout(location = 0) out vec4 color;

void main() {
  vec3 pattern = texture(pattern_map, surface_uv * vec2(2.0, 1.0)).rgb;
  vec2 bent = surface_uv + 0.03 * sin(9.0 * object_position.xy + 3.0 * object_position.z);
  float grain = texture(grain_map, bent * 2.0).r;
  float wear = exp(-2.0 * grain) * (0.7 + 0.3 * sin(7.0 * object_position.y + 4.0 * grain));
  vec3 base = mix(pattern, vec3(0.55, 0.4, 0.3), wear) * (0.75 + 0.25 * sqrt(grain + 0.05));
  color = vec4(lightSurface(base, world_position, world_normal), 1.0);
}

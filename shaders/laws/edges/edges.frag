// Derivatives and implicit levels of detail at every kind of edge: borders of triangles, nearer surfaces, and holes of an alpha test before and
// after them.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../scene.glsl"

layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 3) in vec2 surface_uv;
layout(set = 0, binding = 1) uniform sampler2D leaf_map;
layout(set = 0, binding = 2) uniform sampler2D grain_map;
layout(location = 0) out vec4 color;

void main() {
  vec4 leaf = texture(leaf_map, surface_uv * vec2(2.0, 2.0));
  if (leaf.a < 0.5) discard;
  vec2 bent = surface_uv + 0.04 * sin(8.0 * object_position.xy + 2.0 * object_position.z);
  float grain = texture(grain_map, bent * 3.0).r;
  float swirl = sin(6.0 * object_position.x + 2.0 * cos(5.0 * object_position.y)) + sin(4.0 * object_position.z + 3.0 * grain);
  float veins = exp(-0.5 * swirl * swirl) * sqrt(0.2 + grain) + 0.2 * cos(9.0 * object_position.y + swirl);
  vec3 base = mix(leaf.rgb, vec3(0.5, 0.6, 0.3), clamp(veins, 0.0, 1.0));
  // What the light's grain is seen through: wider where the surface turns away.
  float width = length(fwidth(surface_uv)) * 20.0;
  vec3 facets = normalize(cross(dFdx(world_position), dFdy(world_position)) + vec3(0.0, 0.0, 1e-6));
  float rim = 0.1 * abs(facets.z) + 0.05 * texture(grain_map, surface_uv * 5.0).g + 0.1 * min(width, 1.0);
  if (rim < 0.09) discard;
  color = vec4(lightSurface(base, world_position, world_normal) + rim, 1.0);
}

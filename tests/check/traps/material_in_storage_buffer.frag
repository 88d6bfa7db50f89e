// expect: verified
// An ordinary material: its numbers lie in a storage buffer, one index for a draw, and decide where textures are sampled. On devices whose
// rejected pixels read nothing from buffers, branch is what can be had.
#version 450
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 facing;
layout(location = 2) in vec2 uv_a;
layout(location = 3) in vec2 uv_b;
layout(location = 0) out vec4 color;
struct Material { vec4 tint; int shade_set; int glow_set; float rough; float pad; };
layout(std430, set = 1, binding = 0) readonly buffer Materials { Material list[]; } materials;
layout(push_constant) uniform Draw { int material; } draw;
layout(set = 0, binding = 0) uniform sampler2D shade_map;
layout(set = 0, binding = 1) uniform sampler2D glow_map;
void main() {
  Material m = materials.list[draw.material];
  float s = 0.0;
  for (int i = 0; i < 24; ++i) s += sin(dot(place, vec3(float(i), 1.3, 0.7))) * cos(facing.x * float(i));
  vec3 c = m.tint.rgb * (0.5 + 0.02 * s);
  if (m.shade_set > -1) c *= texture(shade_map, m.shade_set == 0 ? uv_a : uv_b).r;
  vec3 g = m.tint.rgb;
  if (m.glow_set > -1) g *= pow(texture(glow_map, m.glow_set == 0 ? uv_a : uv_b).rgb, vec3(2.2));
  color = vec4(c + g, 1.0);
}

// expect: verified
// The material of material_in_storage_buffer.frag in a uniform block: every strategy can have it.
#version 450
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 facing;
layout(location = 2) in vec2 uv_a;
layout(location = 3) in vec2 uv_b;
layout(location = 0) out vec4 color;
struct Material { vec4 tint; int shade_set; int glow_set; float rough; float pad; };
layout(set = 1, binding = 0) uniform Materials { Material list[4]; } materials;
layout(push_constant) uniform Draw { int material; } draw;
layout(set = 0, binding = 0) uniform sampler2D shade_map;
layout(set = 0, binding = 1) uniform sampler2D glow_map;
void main() {
  Material m = materials.list[draw.material & 3];
  float s = 0.0;
  for (int i = 0; i < 24; ++i) s += sin(dot(place, vec3(float(i), 1.3, 0.7))) * cos(facing.x * float(i));
  vec3 c = m.tint.rgb * (0.5 + 0.02 * s);
  if (m.shade_set > -1) c *= texture(shade_map, m.shade_set == 0 ? uv_a : uv_b).r;
  vec3 g = m.tint.rgb;
  if (m.glow_set > -1) g *= pow(texture(glow_map, m.glow_set == 0 ? uv_a : uv_b).rgb, vec3(2.2));
  color = vec4(c + g, 1.0);
}

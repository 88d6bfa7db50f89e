#version 450
layout(set = 0, binding = 1) uniform sampler2D normal_map;
layout(set = 0, binding = 2) uniform sampler2D place_map;
layout(location = 0) in vec2 screen_uv;
layout(location = 0) out vec4 color;

void main() {
  vec4 normal = textureLod(normal_map, screen_uv, 0.0);
  vec3 place = textureLod(place_map, screen_uv, 0.0).xyz;
  vec3 light = vec3(0.05);
  for (int i = 0; i < 24; ++i) {
    vec3 lamp = vec3(3.0 * sin(float(i)), 2.0 * cos(float(i) * 1.7), 2.5 + sin(float(i) * 2.3));
    vec3 to_lamp = lamp - place;
    light += vec3(0.06, 0.05, 0.04) * max(dot(normal.xyz, normalize(to_lamp)), 0.0) * (0.6 + 0.4 * sin(dot(to_lamp, vec3(1.3, 0.7, 2.1))));
  }
  float vignette = 1.0 - 0.4 * dot(screen_uv - 0.5, screen_uv - 0.5);
  color = vec4(mix(vec3(0.1, 0.15, 0.3), light, normal.a) * vignette, 1.0);
}

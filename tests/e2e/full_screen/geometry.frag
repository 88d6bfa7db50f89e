#version 450
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(location = 0) out vec4 normal_out;
layout(location = 1) out vec4 place_out;

void main() {
  normal_out = vec4(normalize(world_normal), 1.0);
  place_out = vec4(world_position, 1.0);
}

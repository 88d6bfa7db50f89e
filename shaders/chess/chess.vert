#version 450

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 surface_uv;

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_direction;
  vec4 king_position;
} scene;
layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

void main() {
  vec4 world = object.model * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = object.normal_matrix * normal;
  surface_uv = uv;
  gl_Position = scene.view_projection * world;
}

#version 450

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_position;
  float exposure;
} scene;

layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 object_position;
layout(location = 1) out vec3 world_position;
layout(location = 2) out vec3 world_normal;

void main() {
  vec4 world = object.model * vec4(position, 1.0);
  object_position = position;
  world_position = world.xyz;
  world_normal = object.normal_matrix * normal;
  gl_Position = scene.view_projection * world;
}

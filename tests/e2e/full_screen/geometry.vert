#version 450
layout(set = 0, binding = 0) uniform Camera { mat4 view_projection; } camera;
layout(push_constant) uniform Object { mat4 model; } object;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;

void main() {
  vec4 world = object.model * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = mat3(object.model) * normal;
  gl_Position = camera.view_projection * world;
}

#version 450
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 object_position;
layout(location = 1) out vec3 object_normal;
layout(location = 2) out vec3 object_camera;

void main() {
  object_position = position;
  object_normal = normal;
  object_camera = (inverse(object.model) * scene.camera_position).xyz;
  gl_Position = scene.view_projection * object.model * vec4(position, 1.0);
}

// What both stages read from the application.
#ifndef TRANSLUCENT_SCENE_GLSL
#define TRANSLUCENT_SCENE_GLSL

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
} scene;

layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

#endif

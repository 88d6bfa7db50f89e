// What both stages read from the application.
#ifndef WORST_SCENE_GLSL
#define WORST_SCENE_GLSL

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 lamp_position;
  vec4 lamp_color;
} scene;

layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

#endif

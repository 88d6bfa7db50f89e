// What both stages of the marble read from the application.
#ifndef MARBLE_SCENE_GLSL
#define MARBLE_SCENE_GLSL

layout(set = 0, binding = 0) uniform Scene {
  mat4 view_projection;
  vec4 camera_position;
  vec4 light_position;
  vec4 light_color;
  vec4 ambient_color;
} scene;

layout(push_constant) uniform Object {
  mat4 model;
  mat3 normal_matrix;
} object;

#endif

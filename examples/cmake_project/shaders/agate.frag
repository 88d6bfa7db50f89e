#version 450
#include "noise.glsl"
layout(set = 0, binding = 0) uniform Frame {
  mat4 view_projection;
  vec3 camera_position;
} frame;
layout(set = 0, binding = 1) uniform sampler2D dust;
layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  float bands = 0.5 + 0.5 * sin(9.0 * layers(object_position * vec3(1.0, 2.0, 1.0), 80));
  vec3 to_camera = normalize(frame.camera_position - world_position);
  float facing = abs(dot(normalize(world_normal), to_camera));
  float specks = textureLod(dust, object_position.xy, 0.0).r;
  color = vec4(mix(vec3(0.5, 0.1, 0.1), vec3(0.9, 0.7, 0.5), bands) * facing + 0.05 * specks, 1.0);
}

#version 450
#include "noise.glsl"
layout(set = 0, binding = 0) uniform Frame {
  mat4 view_projection;
  vec3 camera_position;
} frame;
layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  float rings = 0.5 + 0.5 * sin(12.0 * length(object_position.xz) + 6.0 * layers(object_position, 70));
  vec3 to_camera = normalize(frame.camera_position - world_position);
  float facing = abs(dot(normalize(world_normal), to_camera));
  color = vec4(mix(vec3(0.35, 0.2, 0.1), vec3(0.7, 0.5, 0.3), rings) * (0.1 + 0.9 * facing), 1.0);
}

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
  float grain = layers(object_position * 3.0, 90);
  vec3 to_camera = normalize(frame.camera_position - world_position);
  float facing = abs(dot(normalize(world_normal), to_camera));
  color = vec4(mix(vec3(0.2, 0.2, 0.25), vec3(0.9, 0.85, 0.8), grain) * (0.2 + 0.8 * facing), 1.0);
}

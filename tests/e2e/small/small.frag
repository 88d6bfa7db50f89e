#version 450
layout(set = 0, binding = 0) uniform Frame {
  mat4 view_projection;
  vec3 camera_position;
  float gain;
} frame;
layout(set = 0, binding = 1) uniform sampler2D grain;
layout(location = 0) in vec3 object_position;
layout(location = 1) in vec3 world_position;
layout(location = 2) in vec3 world_normal;
layout(location = 0) out vec4 color;

void main() {
  float waves = 0.0;
  vec3 point = object_position * 2.0;
  for (int i = 0; i < 12; ++i) {
    waves += 0.08 * sin(point.x + 1.3 * sin(point.y) + 0.7 * sin(point.z));
    point = point.yzx * 1.4 + 0.3;
  }
  float pattern = 0.5 + 0.4 * waves;
  vec3 to_camera = normalize(frame.camera_position - world_position);
  float facing = abs(dot(normalize(world_normal), to_camera));
  float grit = texture(grain, object_position.xy).r;
  color = vec4(vec3(pattern, pattern * 0.8, 1.0 - pattern) * facing * frame.gain + 0.05 * grit, 1.0);
}

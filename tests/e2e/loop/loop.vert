#version 450
layout(set = 0, binding = 0) uniform Frame { mat4 view_projection; } frame;
layout(push_constant) uniform Object { mat4 model; } object;
layout(location = 0) in vec3 position;
layout(location = 0) out vec2 uv;

void main() {
  uv = 0.5 + 0.5 * position.xy;
  gl_Position = frame.view_projection * object.model * vec4(position, 1.0);
}

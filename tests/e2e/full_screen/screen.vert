#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec2 screen_uv;

void main() {
  screen_uv = uv;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.5, 1.0);
}

// expect: verified
#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform Scene { vec2 scale; } scene;
void main() {
  ivec2 place = ivec2(uv * 40.0 * (1.0 + scene.scale));
  for (int turn = 0; turn < 100; ++turn) {
    if (place.x > 0) place.y -= 1;
    if (place.x < 0) place.y += 1;
    place.x += place.y / 2;
  }
  if (place.x < 0) place = ivec2(-place.x, 0);
  while (place.x > 15) place = ivec2(place.x - 16, 0);
  float shades[16] = float[](0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5);
  color = vec4(shades[place.x], float(place.x), 0.0, 1.0);
}

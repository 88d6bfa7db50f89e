// expect: verified
// Writes through several access chains into one local array within a loop.
#version 450
layout(location = 0) in vec2 uv;
layout(location = 1) flat in int lane;
layout(location = 0) out vec4 color;
struct Cell { vec2 place; float weights[4]; };
void main() {
  Cell cells[5];
  for (int i = 0; i < 5; ++i) {
    cells[i].place = uv * float(i);
    for (int j = 0; j < 4; ++j) cells[i].weights[j] = float(i * j) * 0.1;
  }
  float sum = 0.0;
  for (int i = 0; i < 30; ++i) {
    int at = (i * 3 + lane) % 5;
    cells[at].weights[i % 4] += sin(uv.x * float(i));
    cells[(at + 1) % 5].place.y = cells[at].weights[(i + 1) % 4];
    if (cells[at].place.y > 0.8) { cells[at].weights[0] = 1.0; continue; }
    sum += cells[at].place.x * cells[at].weights[0];
  }
  color = vec4(sum, cells[2].place, cells[lane % 5].weights[1]);
}

// expect: verified
// A search tree in an array of structures: endless-looking loops that functions return from, called in loops, indices from memory.
#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
struct Node { int value; int left; int right; };
Node tree[10];
void grow(inout int count, int value) {
  tree[count].value = value;
  tree[count].left = -1;
  tree[count].right = -1;
  int at = 0;
  while (true) {
    if (count == 0) break;
    if (value <= tree[at].value) {
      if (tree[at].left < 0) { tree[at].left = count; break; }
      at = tree[at].left;
      continue;
    }
    if (tree[at].right < 0) { tree[at].right = count; break; }
    at = tree[at].right;
  }
  ++count;
}
int depthOf(int wanted) {
  int at = 0, depth = 1;
  while (true) {
    if (at < 0) return -1;
    if (tree[at].value == wanted) return depth;
    at = wanted <= tree[at].value ? tree[at].left : tree[at].right;
    ++depth;
  }
}
void main() {
  int count = 0;
  for (int i = 0; i < 9; ++i) grow(count, (i * 7 + int(uv.x * 5.0)) % 10);
  float sum = 0.0;
  for (int wanted = 0; wanted < 12; ++wanted) {
    int depth = depthOf(wanted);
    if (depth < 0) continue;
    sum += sin(uv.y * float(depth) + float(wanted));
  }
  float heavy = 0.0;
  for (int i = 0; i < 16; ++i) heavy += cos(uv.x * float(i) + sum);
  color = vec4(sum * 0.1, heavy * 0.05, float(depthOf(int(uv.y * 10.0))), 1.0);
}

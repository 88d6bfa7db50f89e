// Loads the same number in every lane and shows where a neighbour did not get it: red by an index that the compiler cannot know to be one for all,
// green by one that it can. runtime/vulkan/lane_probe.cpp knows the places.
#version 450
layout(early_fragment_tests) in;
layout(std430, set = 0, binding = 0) readonly buffer Values { float values[]; } numbers;
layout(location = 0) out vec4 color;

float change(float value) { return min(abs(dFdxFine(value)) + abs(dFdyFine(value)), 1.0); }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (at == ivec2(7, 2)) discard;
  float by_place = change(numbers.values[at.x + 16 * at.y]);
  float by_constant = change(numbers.values[3]);
  color = vec4(by_place, by_constant, 0.0, 1.0);
}

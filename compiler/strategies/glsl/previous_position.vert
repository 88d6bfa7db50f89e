// The vertex side: the clone that runs on last frame's inputs goes first, so that the original has the last word on every output.
layout(location = PREVIOUS_LOCATION) out vec3 reprise_previous;
layout(set = REPRISE_SET, binding = 1, std140) uniform RepriseDraw { uint valid_last_frame; } reprise_draw;

vec4 reprise_previous_position;
void reprise_current() {}
void reprise_prior() {}

void main() {
  reprise_prior();
  reprise_current();
#if ORTHOGRAPHIC
  vec3 previous = reprise_previous_position.xyz;
#else
  vec3 previous = reprise_previous_position.xyw;
#endif
  reprise_previous = reprise_draw.valid_last_frame != 0u ? previous : vec3(4.0, 4.0, -1.0);
}

// The vertex side: where the vertex was in the last frame, in pixels of that frame's viewport (lookup.glsl says how). The clone that runs on last frame's inputs goes first, so that the original has the last word on every output.
#include "frame_uniforms.glsl"
layout(location = PREVIOUS_LOCATION) out vec3 reprise_previous;
layout(set = REPRISE_SET, binding = 1, std140) uniform RepriseDraw { uint valid_last_frame; } reprise_draw;

vec4 reprise_previous_position;
void reprise_current() {}
void reprise_prior() {}

void main() {
  reprise_prior();
  reprise_current();
  vec4 clip = reprise_previous_position;
  vec4 viewport = reprise.previous_viewport;
  vec2 scale = 0.5 * viewport.zw;
  vec2 offset = scale + viewport.xy;
#if ORTHOGRAPHIC
  vec3 previous = vec3(clip.xy * scale + offset, clip.z);
#else
  vec3 previous = vec3(clip.xy * scale + clip.w * offset, clip.w);
#endif
  // Outside of every image and behind every camera.
  bool known = reprise_draw.valid_last_frame != 0u;
  known = known && reprise.history_valid != 0u;
  reprise_previous = known ? previous : vec3(8.0, 8.0, -1.0);
}

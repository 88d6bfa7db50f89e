// Reprise's own uniforms: struct FrameUniforms of runtime/package/recipe.h.
layout(set = REPRISE_SET, binding = 0, std140) uniform RepriseFrame {
  uint frame;
  uint period_frames;
  uint history_valid;
  uint columns_shift;   // log2 of the columns of refresh groups
  vec4 viewport;
  vec4 previous_viewport;
  vec4 depth_range;     // stored = depth * x + y; valid in z..w
  vec4 tolerance;       // quantization step, slope factor, relative epsilon, slope cap
  vec4 payload_scale;   // encoded = payload * scale + offset
  vec4 payload_offset;
  vec4 payload_range;   // x..y: encoded values that can be stored
  vec4 free_payload;
} reprise;

// Reprise's own uniforms: struct FrameUniforms of runtime/package/recipe.h. What is the same in every frame of a recipe is not
// here but in macros (compiler/strategies/build_recipe.cpp): a uniform costs more to load than a constant, on CPU devices much more.
layout(set = REPRISE_SET, binding = 0, std140) uniform RepriseFrame {
  uint frame;
  uint period_frames;
  uint history_valid;
  uint tiles;           // of the target: across | down << 16, where tiles are flagged
  vec4 viewport;
  vec4 previous_viewport;
  uvec4 due;            // which blocks are due: struct DueBlocks of runtime/package/recipe.h
  vec4 free_payload[4];
} reprise;

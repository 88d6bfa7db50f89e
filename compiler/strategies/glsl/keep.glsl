// What a miss leaves for the pass that repairs it: the shader's inputs, bit by bit (kept_inputs.h), and a flag for its tile.
// The first word is FragCoord.w, which no fragment has as 0: 0 stands for a pixel that needs no repair.
KEPT_GIVEN
layout(location = KEPT_LOCATION) out uvec4 reprise_kept[KEPT_TARGETS];
layout(set = REPRISE_SET, binding = FLAGS_BINDING, std430) buffer RepriseTiles { uint reprise_flags[]; };

void repriseKeep() {
  KEEP
  uvec2 tile = uvec2(gl_FragCoord.xy) / TILE_PIXELS;
  atomicOr(reprise_flags[tile.y * (reprise.tiles & 0xffffu) + tile.x], 1u);
}

void repriseKeepNothing() { reprise_kept[0] = uvec4(0u); }

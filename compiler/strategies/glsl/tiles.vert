// A quad for each tile that was flagged; of the others a point, which covers nothing. The viewport is that of
// all tiles, which may reach beyond the target.
#include "frame_uniforms.glsl"
layout(set = REPRISE_SET, binding = FLAGS_BINDING, std430) readonly buffer RepriseTiles { uint reprise_flags[]; };

void main() {
  uint index = uint(gl_InstanceIndex);
  uvec2 tiles = uvec2(reprise.tiles & 0xffffu, reprise.tiles >> 16);
  uvec2 tile = uvec2(index % tiles.x, index / tiles.x);
  if (reprise_flags[index] != 0u) tile += uvec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
  gl_Position = vec4(vec2(tile) * 2.0 / vec2(tiles) - 1.0, 0.0, 1.0);
}

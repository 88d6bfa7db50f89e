// What a mesh uploads for each vertex.
#pragma once

#include <cstddef>

namespace reprise {

// The vertex inputs "position", "normal", "tangent", "uv" and "color" by name.
struct Vertex {
  float position[3];
  float normal[3];
  float tangent[4];  // w: handedness, bitangent = w * cross(normal, tangent)
  float uv[2];
  float color[4];
};

inline constexpr std::size_t kMorphTargets = 4;  // kept of a primitive

// How a vertex is skinned and morphed: the inputs "joints" and "weights", and "morph_position_0", "morph_normal_0" to 3.
// joints: indices into the skin's joints, as floats; weights sum to 1. Morph values are differences.
struct DeformVertex {
  float joints[4];
  float weights[4];
  float morph_position[kMorphTargets][3];
  float morph_normal[kMorphTargets][3];
};

}  // namespace reprise

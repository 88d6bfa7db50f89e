// Built-in meshes as indexed triangle lists, counter-clockwise seen from outside.
#pragma once

#include <cstdint>
#include <vector>

#include "profiler/scenario/scenario.h"

namespace reprise {

// One vertex as uploaded: the vertex inputs "position", "normal", "tangent", "uv" and "color" by name.
struct Vertex {
  float position[3];
  float normal[3];
  float tangent[4];  // w: handedness
  float uv[2];
  float color[4];
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

Mesh buildMesh(const MeshSpec& spec);

}  // namespace reprise

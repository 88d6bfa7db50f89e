// Built-in meshes as indexed triangle lists, counter-clockwise seen from outside.
#pragma once

#include <cstdint>
#include <vector>

#include "profiler/gltf/vertex.h"
#include "profiler/scenario/scenario.h"

namespace reprise {

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

Mesh buildMesh(const MeshSpec& spec);

}  // namespace reprise

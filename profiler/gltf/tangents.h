// Tangents of a triangle mesh by the standard of MikkTSpace (Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited",
// section 6): per triangle the direction of growing u, projected into the plane of the corner's normal, averaged with the angles of the
// corners as weights over the triangles that meet in the vertex across edges and have the same handedness.
//
// Vertices are alike by position, normal and uv. Where the corners of one vertex get different tangents it is split. As normal maps of glTF
// have their y upwards and its v runs down, v is turned over: w = 1 where u and -v run counter-clockwise about the normal.
#pragma once

#include <cstdint>
#include <vector>

#include "profiler/gltf/vertex.h"

namespace reprise {

// deform: empty or as long as vertices; grows with them.
void addTangents(std::vector<Vertex>& vertices, std::vector<DeformVertex>& deform, std::vector<std::uint32_t>& indices);

}  // namespace reprise

#include "profiler/gltf/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numeric>

namespace reprise {
namespace {

glm::dvec3 positionOf(const Vertex& vertex) { return {vertex.position[0], vertex.position[1], vertex.position[2]}; }
glm::dvec3 normalOf(const Vertex& vertex) { return {vertex.normal[0], vertex.normal[1], vertex.normal[2]}; }

glm::dvec3 unit(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 1e-30 ? vector / length : glm::dvec3(0);
}

glm::dvec3 inPlane(const glm::dvec3& vector, const glm::dvec3& normal) { return unit(vector - normal * glm::dot(normal, vector)); }

// The first vertex that is alike, by position, normal and uv.
std::vector<std::uint32_t> weld(const std::vector<Vertex>& vertices) {
  std::map<std::array<float, 8>, std::uint32_t> first;
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    welded[i] = first.try_emplace({v.position[0], v.position[1], v.position[2], v.normal[0], v.normal[1], v.normal[2], v.uv[0], v.uv[1]}, i)
                    .first->second;
  }
  return welded;
}

struct Face {
  glm::dvec3 along_u{0};
  bool positive = true;
  bool flat = false;  // without area in the texture: takes its neighbours' tangents
};

Face faceOf(const std::vector<Vertex>& vertices, const std::uint32_t* corner) {
  const Vertex &a = vertices[corner[0]], &b = vertices[corner[1]], &c = vertices[corner[2]];
  const double s1 = double(b.uv[0]) - a.uv[0], s2 = double(c.uv[0]) - a.uv[0];
  const double t1 = double(a.uv[1]) - b.uv[1], t2 = double(a.uv[1]) - c.uv[1];
  const double area = s1 * t2 - s2 * t1;
  Face face;
  face.flat = std::abs(area) < 1e-30;
  face.positive = area > 0;
  const glm::dvec3 d1 = positionOf(b) - positionOf(a), d2 = positionOf(c) - positionOf(a);
  face.along_u = unit(t2 * d1 - t1 * d2) * (face.positive ? 1.0 : -1.0);
  return face;
}

// Sets of corners, joined step by step.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::size_t find(std::size_t at) {
    while (parent_[at] != at) at = parent_[at] = parent_[parent_[at]];
    return at;
  }
  void join(std::size_t a, std::size_t b) { parent_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

 private:
  std::vector<std::size_t> parent_;
};

// Corners of one vertex belong together where their triangles share an edge and a handedness.
Groups groupCorners(const std::vector<Face>& faces, const std::vector<std::uint32_t>& indices, const std::vector<std::uint32_t>& welded) {
  Groups groups(indices.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::size_t, std::size_t>>> edges;
  for (std::size_t corner = 0; corner < indices.size(); ++corner) {
    const std::size_t next = corner / 3 * 3 + (corner + 1) % 3;
    const std::uint32_t a = welded[indices[corner]], b = welded[indices[next]];
    edges[std::minmax(a, b)].push_back(a < b ? std::pair(corner, next) : std::pair(next, corner));
  }
  for (const auto& [edge, uses] : edges)
    for (std::size_t i = 1; i < uses.size(); ++i)
      for (std::size_t j = 0; j < std::min<std::size_t>(i, 8); ++j) {
        const Face &one = faces[uses[i].first / 3], &other = faces[uses[j].first / 3];
        if (!one.flat && !other.flat && one.positive != other.positive) continue;
        groups.join(uses[i].first, uses[j].first);
        groups.join(uses[i].second, uses[j].second);
      }
  return groups;
}

double angleAt(const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices, std::size_t corner) {
  const std::size_t base = corner / 3 * 3;
  const Vertex& here = vertices[indices[corner]];
  const glm::dvec3 normal = normalOf(here);
  const glm::dvec3 one = inPlane(positionOf(vertices[indices[base + (corner + 1) % 3]]) - positionOf(here), normal);
  const glm::dvec3 other = inPlane(positionOf(vertices[indices[base + (corner + 2) % 3]]) - positionOf(here), normal);
  return std::acos(std::clamp(glm::dot(one, other), -1.0, 1.0));
}

std::array<float, 4> finished(const glm::dvec3& sum, bool positive, const glm::dvec3& normal) {
  glm::dvec3 tangent = inPlane(sum, normal);
  if (glm::length(tangent) < 0.5) tangent = inPlane(std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), normal);
  return {static_cast<float>(tangent.x), static_cast<float>(tangent.y), static_cast<float>(tangent.z), positive ? 1.0f : -1.0f};
}

}  // namespace

void addTangents(std::vector<Vertex>& vertices, std::vector<DeformVertex>& deform, std::vector<std::uint32_t>& indices) {
  std::vector<Face> faces;
  for (std::size_t corner = 0; corner + 2 < indices.size(); corner += 3) faces.push_back(faceOf(vertices, &indices[corner]));
  Groups groups = groupCorners(faces, indices, weld(vertices));
  std::vector<glm::dvec3> sums(indices.size(), glm::dvec3(0));
  std::vector<char> positive(indices.size(), 1);
  for (std::size_t corner = 0; corner < indices.size(); ++corner) {
    const Face& face = faces[corner / 3];
    if (face.flat) continue;
    const std::size_t group = groups.find(corner);
    sums[group] += inPlane(face.along_u, normalOf(vertices[indices[corner]])) * angleAt(vertices, indices, corner);
    positive[group] = face.positive;
  }
  std::map<std::pair<std::uint32_t, std::array<float, 4>>, std::uint32_t> given;
  std::vector<char> taken(vertices.size(), 0);
  for (std::size_t corner = 0; corner < indices.size(); ++corner) {
    const std::uint32_t index = indices[corner];
    const std::size_t group = groups.find(corner);
    const std::array<float, 4> tangent = finished(sums[group], positive[group] != 0, normalOf(vertices[index]));
    const auto [place, fresh] = given.try_emplace({index, tangent}, index);
    if (fresh && taken[index]) {
      place->second = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(Vertex(vertices[index]));
      if (!deform.empty()) deform.push_back(DeformVertex(deform[index]));
    }
    taken[index] = 1;
    indices[corner] = place->second;
    std::copy(tangent.begin(), tangent.end(), vertices[place->second].tangent);
  }
}

}  // namespace reprise

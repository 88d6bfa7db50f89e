#include "profiler/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "profiler/scene/lattice_noise.h"

namespace reprise {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

// A point of a parametric surface. cross(along_u, along_v) points outwards where it has a length; normal is
// given.
struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;
  glm::dvec3 along_u;
};

// The surface at row v and column u of the grid. A closed surface must return the very same position for
// column 0 and the last one: cracks would show the background.
using Surface = std::function<SurfacePoint(int column, int row)>;

glm::dvec3 anyPerpendicular(const glm::dvec3& direction) {
  const glm::dvec3 axis = std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(axis, direction));
}

Vertex vertexOf(const SurfacePoint& point, double u, double v) {
  const glm::dvec3 normal = glm::normalize(point.normal);
  glm::dvec3 tangent = point.along_u - normal * glm::dot(normal, point.along_u);
  tangent = glm::length(tangent) > 1e-9 ? glm::normalize(tangent) : anyPerpendicular(normal);
  Vertex vertex{};
  for (int i = 0; i < 3; ++i) {
    vertex.position[i] = static_cast<float>(point.position[i]);
    vertex.normal[i] = static_cast<float>(normal[i]);
    vertex.tangent[i] = static_cast<float>(tangent[i]);
    vertex.color[i] = static_cast<float>(0.5 + 0.5 * normal[i]);
  }
  // v grows along cross(normal, tangent) on all surfaces here.
  vertex.tangent[3] = 1;
  vertex.color[3] = 1;
  vertex.uv[0] = static_cast<float>(u);
  vertex.uv[1] = static_cast<float>(v);
  return vertex;
}

bool samePlace(const Vertex& a, const Vertex& b) {
  return std::equal(a.position, a.position + 3, b.position);
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vertex &first = mesh.vertices[a], &second = mesh.vertices[b], &third = mesh.vertices[c];
  // Where a row shrinks to a point (a pole), half of the triangles have no area.
  if (samePlace(first, second) || samePlace(second, third) || samePlace(third, first)) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

Mesh buildGrid(int columns, int rows, const Surface& surface) {
  Mesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      mesh.vertices.push_back(vertexOf(surface(column, row), static_cast<double>(column) / columns,
                                       static_cast<double>(row) / rows));
    }
  }
  const auto index = [&](int column, int row) {
    return static_cast<std::uint32_t>(row * (columns + 1) + column);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      addTriangle(mesh, index(column, row), index(column + 1, row), index(column + 1, row + 1));
      addTriangle(mesh, index(column, row), index(column + 1, row + 1), index(column, row + 1));
    }
  }
  return mesh;
}

// Around +y, counter-clockwise seen from above, from +z; columns that are a whole turn apart are the same to
// the bit.
glm::dvec3 around(int column, int columns) {
  const double angle = kTurn_rad * (column % columns) / columns;
  return {std::sin(angle), 0, std::cos(angle)};
}

glm::dvec3 aroundTangent(int column, int columns) {
  const glm::dvec3 outwards = around(column, columns);
  return {outwards.z, 0, -outwards.x};
}

Mesh buildSphere(const MeshSpec& spec) {
  return buildGrid(spec.segments_u, spec.segments_v, [&](int column, int row) {
    const double latitude = std::numbers::pi * (static_cast<double>(row) / spec.segments_v - 0.5);
    const bool pole = row == 0 || row == spec.segments_v;
    const double ring = pole ? 0 : std::cos(latitude);
    const double height = pole ? (row == 0 ? -1 : 1) : std::sin(latitude);
    const glm::dvec3 normal = around(column, spec.segments_u) * ring + glm::dvec3(0, height, 0);
    return SurfacePoint{normal * static_cast<double>(spec.radius), normal,
                        aroundTangent(column, spec.segments_u)};
  });
}

// The curve of a (p, q) torus knot about the z axis: p turns about the axis, q about the tube of the torus.
// Extent 1.5 radius.
glm::dvec3 knotPoint(const MeshSpec& spec, double angle) {
  const double about_axis = spec.p * angle, about_tube = spec.q * angle;
  const double distance = 1 + 0.5 * std::cos(about_tube);
  return glm::dvec3(distance * std::cos(about_axis), distance * std::sin(about_axis),
                    0.5 * std::sin(about_tube)) *
         static_cast<double>(spec.radius);
}

Mesh buildTorusKnot(const MeshSpec& spec) {
  return buildGrid(spec.segments_v, spec.segments_u, [&](int column, int row) {
    const double angle = kTurn_rad * (row % spec.segments_u) / spec.segments_u;
    const glm::dvec3 center = knotPoint(spec, angle), ahead = knotPoint(spec, angle + 1e-3),
                     behind = knotPoint(spec, angle - 1e-3);
    const glm::dvec3 tangent = glm::normalize(ahead - behind);
    // Away from the ring in the middle of the torus's tube: never parallel to the curve, and periodic with
    // it.
    const glm::dvec3 spine =
        glm::normalize(glm::dvec3(center.x, center.y, 0)) * static_cast<double>(spec.radius);
    const glm::dvec3 away = center - spine;
    const glm::dvec3 side = glm::normalize(away - tangent * glm::dot(away, tangent));
    const glm::dvec3 other = glm::cross(tangent, side);
    const double turn = kTurn_rad * (column % spec.segments_v) / spec.segments_v;
    const glm::dvec3 normal = side * std::cos(turn) + other * std::sin(turn);
    const glm::dvec3 along = other * std::cos(turn) - side * std::sin(turn);
    return SurfacePoint{center + normal * static_cast<double>(spec.tube_radius), normal, along};
  });
}

// Rows go towards -z, so that u x v points up.
glm::dvec2 planePoint(const MeshSpec& spec, int column, int row) {
  return {spec.size * (static_cast<double>(column) / spec.segments_u - 0.5),
          spec.size * (0.5 - static_cast<double>(row) / spec.segments_v)};
}

Mesh buildPlane(const MeshSpec& spec) {
  return buildGrid(spec.segments_u, spec.segments_v, [&](int column, int row) {
    const glm::dvec2 point = planePoint(spec, column, row);
    return SurfacePoint{{point.x, 0, point.y}, {0, 1, 0}, {1, 0, 0}};
  });
}

// Hills of four octaves, the widest a fifth of the edge.
double terrainHeight(const MeshSpec& spec, const glm::dvec2& point) {
  const glm::dvec2 cell = point * (5.0 / spec.size);
  return spec.height * fractalNoise(cell.x, cell.y, spec.seed, 0);
}

Mesh buildTerrain(const MeshSpec& spec) {
  const double step = spec.size * 1e-3;
  return buildGrid(spec.segments_u, spec.segments_v, [&](int column, int row) {
    const glm::dvec2 point = planePoint(spec, column, row);
    const double slope_x = (terrainHeight(spec, point + glm::dvec2(step, 0)) -
                            terrainHeight(spec, point - glm::dvec2(step, 0))) /
                           (2 * step);
    const double slope_z = (terrainHeight(spec, point + glm::dvec2(0, step)) -
                            terrainHeight(spec, point - glm::dvec2(0, step))) /
                           (2 * step);
    return SurfacePoint{
        {point.x, terrainHeight(spec, point), point.y}, {-slope_x, 1, -slope_z}, {1, slope_x, 0}};
  });
}

// Catmull-Rom curve through the profile, at `place` in units of its points; ends as if the end points were
// doubled.
struct ProfilePoint {
  glm::dvec2 point, direction;
};

ProfilePoint profileAt(const std::vector<std::array<float, 2>>& profile, double place) {
  const int last = static_cast<int>(profile.size()) - 1;
  const int span = std::clamp(static_cast<int>(std::floor(place)), 0, last - 1);
  const double t = place - span;
  const auto at = [&](int i) {
    const std::array<float, 2>& point = profile[static_cast<std::size_t>(std::clamp(i, 0, last))];
    return glm::dvec2(point[0], point[1]);
  };
  const glm::dvec2 a = at(span), b = at(span + 1), slope_a = (b - at(span - 1)) * 0.5,
                   slope_b = (at(span + 2) - a) * 0.5;
  const glm::dvec2 rest = b - a;
  const glm::dvec2 c2 = 3.0 * rest - 2.0 * slope_a - slope_b, c3 = slope_a + slope_b - 2.0 * rest;
  ProfilePoint result{a + t * (slope_a + t * (c2 + t * c3)), slope_a + t * (2.0 * c2 + 3.0 * t * c3)};
  if (place >= last) result.point = b;  // exactly, for closed ends
  if (glm::length(result.direction) < 1e-9) result.direction = rest;
  result.point.x = std::max(0.0, result.point.x);
  return result;
}

Mesh buildRevolution(const MeshSpec& spec) {
  const double last = static_cast<double>(spec.profile.size()) - 1;
  return buildGrid(spec.segments_u, spec.segments_v, [&](int column, int row) {
    const ProfilePoint profile = profileAt(spec.profile, last * row / spec.segments_v);
    const glm::dvec3 outwards = around(column, spec.segments_u);
    const bool tip = profile.point.x == 0;
    const glm::dvec3 normal = tip ? glm::dvec3(0, row == 0 ? -1 : 1, 0)
                                  : outwards * profile.direction.y - glm::dvec3(0, profile.direction.x, 0);
    return SurfacePoint{outwards * profile.point.x + glm::dvec3(0, profile.point.y, 0), normal,
                        aroundTangent(column, spec.segments_u)};
  });
}

// Along the radius by value noise over longitude and latitude, fading to none at the poles, where all longitudes meet.
double displacedRadius(const MeshSpec& spec, double column, double row) {
  const double u = column / spec.segments_u, v = row / spec.segments_v;
  const double ring = std::sin(std::numbers::pi * v);
  const double cells = spec.cells;
  return spec.radius * (1 + spec.height * ring * (2 * fractalNoise(u * cells, v * cells / 2, spec.seed, spec.cells) - 1));
}

Mesh buildDisplacedSphere(const MeshSpec& spec) {
  const auto point = [&](double column, double row) {
    const double longitude = kTurn_rad * column / spec.segments_u, latitude = std::numbers::pi * (row / spec.segments_v - 0.5);
    const glm::dvec3 direction(std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude));
    return direction * displacedRadius(spec, column, row);
  };
  constexpr double kStep = 1e-3;  // of a segment
  return buildGrid(spec.segments_u, spec.segments_v, [&](int column, int row) {
    const int own = column % spec.segments_u;
    if (row == 0 || row == spec.segments_v) {
      const double height = row == 0 ? -1 : 1;
      return SurfacePoint{{0, height * spec.radius, 0}, {0, height, 0}, aroundTangent(column, spec.segments_u)};
    }
    const glm::dvec3 along_u = point(own + kStep, row) - point(own - kStep, row);
    const glm::dvec3 along_v = point(own, row + kStep) - point(own, row - kStep);
    return SurfacePoint{point(own, row), glm::cross(along_u, along_v), along_u};
  });
}

}  // namespace

Mesh buildMesh(const MeshSpec& spec) {
  switch (spec.kind) {
    case MeshKind::kSphere:
      return buildSphere(spec);
    case MeshKind::kTorusKnot:
      return buildTorusKnot(spec);
    case MeshKind::kPlane:
      return buildPlane(spec);
    case MeshKind::kTerrain:
      return buildTerrain(spec);
    case MeshKind::kRevolution:
      return buildRevolution(spec);
    case MeshKind::kDisplacedSphere:
      return buildDisplacedSphere(spec);
  }
  return {};
}

}  // namespace reprise
